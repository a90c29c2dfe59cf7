// SPDX-License-Identifier: GPL-3.0-or-later
// Tag reads that an AGV of this family really made, sent through the reader's stream again. The recordings
// are not part of the project; without them the test skips itself.
#include "protocol/reader_stream.h"

#include <gtest/gtest.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace agv;
using namespace agv::protocol;
namespace fs = std::filesystem;

namespace {

std::string contentOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> split(std::string_view text, char separator)
{
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back().push_back(c);
    }
    return parts;
}

/// Rows of the unchanged recordings: n, five pairs of (last four UID digits, RSSI), ...; lines end in CR
/// only.
std::vector<CompleteRead> recordedReads(const std::vector<std::string>& rows)
{
    std::vector<CompleteRead> reads;
    for (const std::string& row : rows) {
        const auto fields = split(row, ',');
        for (std::size_t i = 1; i + 1 < fields.size() && i <= 9; i += 2) {
            if (fields[i].size() != 4)
                continue;
            const auto uid = parseTagUid("E00401503A5B" + fields[i]);
            if (uid)
                reads.push_back({*uid, std::stoi(fields[i + 1]), -1});
        }
    }
    return reads;
}

} // namespace

TEST(RecordedReaderTables, comeBackFromTheWireReadByRead)
{
    const fs::path folder = fs::path(AGV_RECORDINGS) / "rfid_dyn_dortmund" / "known";
    if (!fs::exists(folder))
        GTEST_SKIP() << "the recordings are not here: " << folder;

    for (const char* const name : {"orig_experiment_1.txt", "orig_firstTest.txt"}) {
        std::vector<std::string> rows;
        LineFramer framer;
        framer.feed(contentOf(folder / name), [&rows](std::string_view line) { rows.emplace_back(line); });
        EXPECT_GE(rows.size(), 40U) << name << ": its lines end in CR only";

        const auto reads = recordedReads(rows);
        EXPECT_GE(reads.size(), 40U) << name;
        ReaderStream stream;
        std::vector<CompleteRead> decoded;
        for (const CompleteRead& read : reads)
            stream.feed(encodeReaderLine(read) + "\r", [&decoded](const ReaderReport& report) {
                decoded.push_back(std::get<CompleteRead>(report));
            });
        EXPECT_EQ(decoded, reads) << name;
        EXPECT_EQ(stream.counts().droppedTotal(), 0U) << dropDetail(stream.counts());
    }
}
