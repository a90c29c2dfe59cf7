// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/uwb_files.h"

#include "core/plant_file.h"
#include "core/text_file.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_stream.h"
#include "recording/anchor_csv.h"
#include "recording/text_lines.h"
#include "recording/trek_config.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <ostream>
#include <system_error>

namespace agv::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largestAnchorFile = std::size_t{1} << 20U;
constexpr std::size_t largestRangeFile = std::size_t{256} << 20U;

std::vector<RangeMeasurement> decodeSerial(const recording::SerialCapture& capture)
{
    using protocol::TrekRanges;
    TrekRanges reader(capture.hasTimes ? TrekRanges::TimeBase::Arrival : TrekRanges::TimeBase::DeviceClock);
    protocol::TrekStream stream;
    std::vector<RangeMeasurement> ranges;
    const auto take = [&](const protocol::TrekReport& report) {
        const protocol::RangeSet set = reader.read(report);
        ranges.insert(ranges.end(), set.begin(), set.end());
    };
    for (const recording::SerialChunk& chunk : capture.chunks)
        stream.feed(chunk.bytes, Time{} + chunk.since, take);
    stream.finish(take);
    return ranges;
}

bool looksLikeXml(std::string_view text)
{
    return recording::trimmed(text.substr(0, 256)).starts_with('<') || text.starts_with("\xef\xbb\xbf<");
}

bool holdsRanges(const fs::path& path)
{
    const auto text = readTextFile(path, largestRangeFile);
    return text && (recording::looksLikeTimedCapture(*text) || recording::looksLikeDecaRangeLog(*text) ||
                    recording::looksLikeRangeCsv(*text) || recording::looksLikeRawCapture(*text));
}

} // namespace

std::optional<int> AnchorSet::indexOf(int id) const
{
    const auto found = std::ranges::find(anchors, id, &UwbAnchor::id);
    if (found == anchors.end())
        return std::nullopt;
    return static_cast<int>(found - anchors.begin());
}

Error inFile(const std::string& path, Error error)
{
    const bool namesLine =
        !error.detail.empty() && std::isdigit(static_cast<unsigned char>(error.detail.front())) != 0;
    error.detail = path + (namesLine ? ":" : ": ") + error.detail;
    return error;
}

void report(const std::string& path, const recording::FileProblems& problems, std::ostream& err)
{
    for (const recording::FileProblem& problem : problems.kept())
        err << recording::problemText(path, problem) << "\n";
    if (problems.count() > problems.kept().size())
        err << path << ": " << problems.count() - problems.kept().size() << " more such lines\n";
}

Result<AnchorSet> readAnchorFile(const std::string& path, std::ostream& err)
{
    const auto text = readTextStream(path, largestAnchorFile);
    if (!text)
        return std::unexpected(text.error());
    if (!looksLikeXml(*text)) {
        auto anchors = recording::readAnchorCsv(*text);
        if (!anchors)
            return std::unexpected(inFile(path, anchors.error()));
        return AnchorSet{std::move(*anchors), {}};
    }
    auto config = recording::readTrekAnchorConfig(*text);
    if (!config)
        return std::unexpected(inFile(path, config.error()));
    report(path, config->problems, err);
    AnchorSet set{std::move(config->anchors), {}};
    for (const RangeCorrection& correction : config->corrections)
        set.corrections_m[{correction.tag, correction.anchor}] = correction.offset_m;
    return set;
}

Result<AnchorSet> readPlantAnchors(const std::string& path)
{
    auto plant = readPlantFile(path);
    if (!plant)
        return std::unexpected(plant.error());
    if (plant->anchors.empty())
        return failure(ErrorCode::BadInput, path + ": has no UWB anchors; give them with --anchors");
    return AnchorSet{std::move(plant->anchors), {}};
}

Result<recording::RangeFile> readRanges(const std::string& path, std::istream& in)
{
    const auto text =
        path == "-" ? readTextStream(in, path, largestRangeFile) : readTextStream(path, largestRangeFile);
    if (!text)
        return std::unexpected(text.error());
    auto file = recording::parseRanges(*text, decodeSerial);
    if (!file)
        return std::unexpected(inFile(path, file.error()));
    return file;
}

Result<std::vector<std::string>> filesOf(const std::string& input)
{
    std::error_code error;
    if (input == "-" || !fs::is_directory(input, error))
        return std::vector{input};
    std::vector<std::string> files;
    for (fs::directory_iterator entry(input, error), end; !error && entry != end; entry.increment(error))
        if (entry->is_regular_file(error) && holdsRanges(entry->path()))
            files.push_back(entry->path().string());
    if (error)
        return failure(ErrorCode::Io, input + ": cannot be read: " + error.message());
    if (files.empty())
        return failure(ErrorCode::NotFound, input + ": no file in this folder holds UWB ranges");
    std::ranges::sort(files);
    return files;
}

} // namespace agv::app
