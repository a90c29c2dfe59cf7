// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/range_file.h"

#include "core/text_file.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_stream.h"
#include "recording/anchor_csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>

using namespace agv;
using namespace agv::recording;
namespace fs = std::filesystem;

namespace {

/// As the program wires it: the decoder is of the protocol, which recording does not know.
std::vector<RangeMeasurement> decodeTrek(const SerialCapture& capture)
{
    using protocol::TrekRanges;
    std::vector<RangeMeasurement> ranges;
    TrekRanges reader(capture.hasTimes ? TrekRanges::TimeBase::Arrival : TrekRanges::TimeBase::DeviceClock);
    protocol::TrekStream stream;
    const auto take = [&](const protocol::TrekReport& report) {
        const protocol::RangeSet set = reader.read(report);
        ranges.insert(ranges.end(), set.begin(), set.end());
    };
    for (const SerialChunk& chunk : capture.chunks)
        stream.feed(chunk.bytes, Time{} + chunk.since, take);
    stream.finish(take);
    return ranges;
}

RangeFile parsed(std::string_view text)
{
    auto file = parseRanges(text, decodeTrek);
    EXPECT_TRUE(file.has_value()) << (file ? "" : file.error().detail);
    return file.value_or(RangeFile{});
}

const std::string trek = "mc 0f 00000663 000005a3 00000512 000004cb 095f c1 00024c24 a0:0\r\n";

} // namespace

TEST(RangeFile, isToldFromItsContent)
{
    EXPECT_EQ(parsed("t_s,tag,anchor,range_m\n1,0,0,1\n").format, RangeFileFormat::RangeCsv);
    EXPECT_EQ(parsed("T:090531088:RR:0:0:760:760:229:3301\r\n").format, RangeFileFormat::DecaRangeLog);
    EXPECT_EQ(parsed(trek).format, RangeFileFormat::SerialCapture);
    EXPECT_EQ(parsed("\xff noise\r\n" + trek).format, RangeFileFormat::SerialCapture);
    EXPECT_EQ(parsed("# agv-uwb-capture 1\n@1500 mc 0f 00000663 000005a3 00000512 000004cb 095f c1 00024c24 "
                     "a0:0\\r\\n\n")
                  .format,
              RangeFileFormat::SerialCapture);
}

TEST(RangeFile, takesTheTimesOfACaptureOrTheClockOfTheUnit)
{
    EXPECT_NEAR(parsed(trek).table.ranges.at(0).time_s, 0x24c24 / 1e3, 1e-9);
    EXPECT_NEAR(parsed("# agv-uwb-capture 1\n@1500 mc 0f 0000\n@1600 0663 000005a3 00000512 000004cb 095f c1 "
                       "00024c24 a0:0\\r\\n\n")
                    .table.ranges.at(0)
                    .time_s,
                1.5, 1e-9);
}

TEST(RangeFile, refusesWhatHoldsNoRanges)
{
    for (const char* const text :
         {"", "hello\n", "a,b\n1,2\n", "t_s,tag,anchor,range_m\n", "mc 0f 00000\n"}) {
        const auto file = parseRanges(text, decodeTrek);
        ASSERT_FALSE(file.has_value()) << text;
        EXPECT_EQ(file.error().code, ErrorCode::BadInput);
    }
    EXPECT_FALSE(parseRanges(trek, nullptr).has_value());
}

TEST(RangeFile, namesTheFileAndTheLineInItsErrors)
{
    const auto missing = readRangeFile("/nowhere/ranges.csv", decodeTrek);
    ASSERT_FALSE(missing.has_value());
    EXPECT_NE(missing.error().detail.find("/nowhere/ranges.csv"), std::string::npos);

    const fs::path path = fs::path(testing::TempDir()) / "agv_bad_ranges.csv";
    ASSERT_TRUE(writeTextFile(path, "t_s,tag,anchor,range_m\n1,0\n").has_value());
    const auto bad = readRangeFile(path, decodeTrek);
    std::remove(path.c_str());
    ASSERT_FALSE(bad.has_value());
    EXPECT_EQ(bad.error().detail, path.string() + ":2: has 2 fields, the header has 4");
}

namespace {

class RecordedRanges : public testing::Test {
protected:
    void SetUp() override
    {
        if (!fs::exists(m_folder))
            GTEST_SKIP() << "the recordings are not here: " << m_folder;
    }
    RangeFile read(const fs::path& name) const
    {
        auto file = readRangeFile(m_folder / name, decodeTrek);
        EXPECT_TRUE(file.has_value()) << (file ? "" : file.error().detail);
        return file.value_or(RangeFile{});
    }
    fs::path m_folder = AGV_RECORDINGS;
};

} // namespace

TEST_F(RecordedRanges, inTablesAreReadToTheLastRow)
{
    struct Expected {
        const char* name;
        std::size_t rows;
        std::vector<std::string> extras;
    };
    for (const Expected& e : {Expected{"trek1000_decarange/ranges_los.csv", 17280, {"point"}},
                              Expected{"trek1000_decarange/ranges_nlos.csv", 17280, {"point", "nlos_label"}},
                              Expected{"lias_trolley/ranges_static.csv", 17277, {"run"}},
                              Expected{"lias_trolley/ranges_dynamic_mid.csv", 29256, {}},
                              Expected{"labyrinth_odom_uwb/ranges.csv", 233, {}}}) {
        const RangeFile file = read(e.name);
        EXPECT_EQ(file.format, RangeFileFormat::RangeCsv);
        EXPECT_EQ(file.table.ranges.size() + file.table.notMeasured, e.rows) << e.name;
        EXPECT_EQ(file.table.extraColumns, e.extras) << e.name;
        EXPECT_TRUE(file.table.problems.empty()) << e.name;
    }
}

TEST_F(RecordedRanges, inLogsOfTheExistingProgramAreReadToTheLastRow)
{
    for (const auto& entry : fs::directory_iterator(m_folder / "trek1000_decarange" / "raw_logs")) {
        const RangeFile file = read(fs::path("trek1000_decarange") / "raw_logs" / entry.path().filename());
        const std::string text = readTextFile(entry.path(), std::size_t{1} << 20U).value_or("");
        const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n'));
        EXPECT_EQ(file.format, RangeFileFormat::DecaRangeLog);
        EXPECT_EQ(file.table.ranges.size(), lines - 1)
            << entry.path().filename() << ": all but the first line";
        EXPECT_TRUE(file.table.problems.empty()) << entry.path().filename();
    }
}

TEST_F(RecordedRanges, ofALogAgreeWithTheTableMadeOfIt)
{
    const RangeFile log = read("trek1000_decarange/raw_logs/001_los_RTLS_log.txt");
    const RangeFile table = read("trek1000_decarange/ranges_los.csv");
    const std::size_t point = *table.table.extraColumn("point");
    std::map<std::pair<int, int>, double> ranges; // by RSEQ and anchor
    for (const RangeMeasurement& range : log.table.ranges)
        ranges.try_emplace({range.sequence, range.anchor}, range.range_m);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < table.table.ranges.size(); ++i) {
        const RangeMeasurement& range = table.table.ranges[i];
        if (table.table.extra(i, point) != "1")
            continue;
        EXPECT_DOUBLE_EQ((ranges[{range.sequence, range.anchor}]), range.range_m);
        ++compared;
    }
    EXPECT_EQ(compared, 160U);
}

TEST_F(RecordedRanges, ofSerialLinesAreDecoded)
{
    EXPECT_EQ(read("trek_lines/ulm_clone_room_b.mc.txt").table.ranges.size(), 4U * 789U - 4U);
    EXPECT_EQ(read("trek_lines/ulm_clone_wall_a.mc.txt").table.ranges.size(), 4U * 66U);
    const RangeFile genuine = read("trek_lines/trek1000_sample.txt");
    EXPECT_GT(genuine.table.ranges.size(), 30U);
}

TEST_F(RecordedRanges, haveAnchorsThatAreRead)
{
    for (const char* const name : {"trek1000_decarange", "lias_trolley", "labyrinth_odom_uwb"}) {
        const auto text = readTextFile(m_folder / name / "anchors.csv", 4096);
        ASSERT_TRUE(text.has_value());
        const auto anchors = readAnchorCsv(*text);
        ASSERT_TRUE(anchors.has_value()) << anchors.error().detail;
        EXPECT_GE(anchors->size(), 4U);
    }
}
