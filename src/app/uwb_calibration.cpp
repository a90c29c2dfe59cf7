// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/uwb_calibration.h"

#include "app/uwb_reports.h"
#include "app/uwb_truth.h"
#include "core/text_file.h"

#include <cmath>
#include <filesystem>
#include <istream>
#include <sstream>
#include <system_error>
#include <tuple>

namespace agv::app {

namespace {

namespace fs = std::filesystem;

/// A moving tag is at another place when it is in another cell of this size.
constexpr double placeSize_m = 0.5;

/// The two names of "RANGES:TRUTH"; a name may have colons when the files exist.
std::optional<std::pair<std::string, std::string>> splitNames(const std::string& files)
{
    std::optional<std::pair<std::string, std::string>> names;
    for (std::size_t colon = files.find(':'); colon != std::string::npos;
         colon = files.find(':', colon + 1)) {
        std::pair candidate(files.substr(0, colon), files.substr(colon + 1));
        std::error_code ignored;
        if (fs::exists(candidate.first, ignored) && fs::exists(candidate.second, ignored))
            return candidate;
        if (!names)
            names = std::move(candidate);
    }
    return names && !names->first.empty() && !names->second.empty() ? names : std::nullopt;
}

bool isSameFile(const std::string& a, const std::string& b)
{
    std::error_code error;
    return fs::equivalent(a, b, error) && !error;
}

} // namespace

Result<UwbCalibration> UwbCalibration::read(const std::string& files, const AnchorSet& anchors,
                                            double height_m, std::ostream& err)
{
    const auto names = splitNames(files);
    if (!names)
        return failure(ErrorCode::BadInput,
                       "--calibrate is \"" + files + "\": it must be RANGES:TRUTH, the names of two files");
    std::istringstream nothing;
    const auto file = readRanges(names->first, nothing);
    if (!file)
        return std::unexpected(file.error());
    const auto text = readTextStream(names->second, largestTruthFile);
    if (!text)
        return std::unexpected(text.error());
    const auto truth = recording::readTruthCsv(*text);
    if (!truth)
        return std::unexpected(inFile(names->second, truth.error()));
    report(names->first, file->table.problems, err);
    report(names->second, truth->problems, err);
    const auto index = TruthIndex::make(*truth, file->table);
    if (!index)
        return std::unexpected(inFile(names->second, index.error()));

    UwbCalibration calibration;
    calibration.m_rangesPath = names->first;
    std::map<std::tuple<std::string, long, long>, int> places;
    const ReportList list = groupReports(file->table, truth->otherColumns);
    for (const UwbReport& moment : list.reports) {
        const auto known = index->at(file->table, moment.rows.front(), moment.time_s);
        if (!known)
            continue;
        const std::string group = list.groupOf(file->table, moment);
        const int place = places
                              .try_emplace({group, std::lround(known->x_m / placeSize_m),
                                            std::lround(known->y_m / placeSize_m)},
                                           static_cast<int>(places.size()))
                              .first->second;
        for (const std::size_t row : moment.rows) {
            const RangeMeasurement& range = file->table.ranges[row];
            const auto anchor = anchors.indexOf(range.anchor);
            if (!anchor)
                continue;
            const UwbAnchor& at = anchors.anchors[static_cast<std::size_t>(*anchor)];
            calibration.m_samples[group].push_back(
                {range.tag, range.anchor, place, range.range_m,
                 std::hypot(at.x - known->x_m, at.y - known->y_m, at.z - known->z_m.value_or(height_m))});
        }
    }
    if (calibration.m_samples.empty())
        return failure(ErrorCode::NoSolution,
                       names->first + ": no range was measured at a place of " + names->second);
    return calibration;
}

bool UwbCalibration::judgesItself(const std::string& path) const
{
    return m_samples.size() == 1 && isSameFile(path, m_rangesPath);
}

Result<estimation::RangeBiases> UwbCalibration::biasesFor(const std::string& path,
                                                          const std::string& group) const
{
    const bool leaveOut = isSameFile(path, m_rangesPath) && m_samples.size() > 1;
    return solveWithout(leaveOut ? &group : nullptr);
}

Result<estimation::RangeBiases> UwbCalibration::solveWithout(const std::string* group) const
{
    estimation::BiasCalibration calibration;
    for (const auto& [name, samples] : m_samples)
        if (group == nullptr || name != *group)
            for (const Sample& sample : samples)
                calibration.add(sample.tag, sample.anchor, sample.place, sample.range_m, sample.distance_m);
    return calibration.solve();
}

} // namespace agv::app
