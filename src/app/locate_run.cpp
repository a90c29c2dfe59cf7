// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/locate_run.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace agv::app {

namespace {

using estimation::AnchorRange;
using estimation::Locator;
using estimation::RangeBias;
using estimation::RangeBiases;

/// Gives a locator what the vehicle did and read up to a time, each once and in the order of time.
class VehicleFeed {
public:
    explicit VehicleFeed(const VehicleData& data) : m_data(data)
    {
        if (!data.odometry.empty())
            m_done_s = data.odometry.front().time_s; // nobody knows when the first row began
    }

    void advance(Locator& locator, double time_s)
    {
        for (; m_nextFix < m_data.floorFixes.size() && m_data.floorFixes[m_nextFix].time_s <= time_s;
             ++m_nextFix) {
            const FloorFix& fix = m_data.floorFixes[m_nextFix];
            drive(locator, fix.time_s);
            locator.floorTag(fix.time_s, fix.position);
        }
        drive(locator, time_s);
    }

private:
    void drive(Locator& locator, double time_s)
    {
        while (m_nextRow < m_data.odometry.size() && m_done_s < time_s) {
            const recording::OdometryRow& row = m_data.odometry[m_nextRow];
            const double until_s = std::min(row.time_s, time_s);
            if (const double dt = until_s - m_done_s; dt > 0.0) {
                locator.odometry(until_s, {row.forward * dt, 0.0, row.turn * dt}, dt);
                m_done_s = until_s;
            }
            if (row.time_s > time_s)
                return;
            ++m_nextRow;
        }
    }

    const VehicleData& m_data;
    std::size_t m_nextRow = 0;
    std::size_t m_nextFix = 0;
    double m_done_s = 0.0; ///< the odometry up to here was given
};

struct Track {
    std::unique_ptr<Locator> locator;
    std::optional<VehicleFeed> vehicle;
};

ReportFix fixFrom(const estimation::Located& located)
{
    ReportFix fix;
    fix.status = located.status;
    fix.position = located.position;
    fix.sd = located.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    fix.heading = located.heading;
    for (const estimation::MeasurementRecord& record : located.records)
        fix.rejected += record.rejected && record.kind == estimation::MeasurementKind::Range ? 1 : 0;
    return fix;
}

constexpr std::string_view methodOfMoving = "ekf-los";
constexpr std::string_view methodOfStanding = "static";
/// Ranges shorter than from where a standing tag is by so many sds are wrong or of a tag that moves.
constexpr double tooShort_sds = 3.0;
/// Share of a standing tag's ranges that may be wrong.
constexpr double mostWrong = 0.05;
/// Fewer reports than this say nothing of motion.
constexpr std::size_t leastReports = 8;

/// Can the ranges be of a tag that stood at `position` all the time? What hides an anchor makes its ranges
/// longer, never shorter; a tag that moves comes nearer to some anchors.
bool stands(const PreparedRanges& ranges, const std::vector<std::size_t>& reports,
            const Eigen::Vector3d& position)
{
    std::size_t count = 0;
    std::size_t tooShort = 0;
    for (const std::size_t report : reports) {
        for (const AnchorRange& range : ranges.of(report)) {
            const double distance_m = (range.anchor - position).norm();
            tooShort += range.range_m < distance_m - tooShort_sds * range.sd_m ? 1U : 0U;
            ++count;
        }
    }
    return reports.size() >= leastReports &&
           static_cast<double>(tooShort) <= mostWrong * static_cast<double>(count);
}

double sdOf(const RangeBias& bias) { return std::hypot(bias.sd_m, bias.noiseSd_m); }

} // namespace

Point2 VehicleData::mountOf(int tag) const
{
    const auto known = mounts.find(tag);
    return mount ? *mount : known != mounts.end() ? known->second : Point2{};
}

PreparedRanges PreparedRanges::none(ReportList list)
{
    PreparedRanges prepared;
    prepared.m_first.assign(list.reports.size() + 1, 0);
    prepared.m_list = std::move(list);
    return prepared;
}

Result<PreparedRanges> PreparedRanges::make(const recording::RangeTable& table, ReportList list,
                                            const AnchorSet& anchors, const UwbCalibration* calibration,
                                            const std::string& path)
{
    PreparedRanges prepared;
    prepared.m_list = std::move(list);
    std::map<std::string, RangeBiases> biases; // by group
    for (const UwbReport& report : prepared.m_list.reports) {
        prepared.m_first.push_back(prepared.m_ranges.size());
        const RangeBiases* known = nullptr;
        if (calibration != nullptr) {
            const std::string group = prepared.m_list.groupOf(table, report);
            auto found = biases.find(group);
            if (found == biases.end()) {
                auto solved = calibration->biasesFor(path, group);
                if (!solved)
                    return std::unexpected(solved.error());
                found = biases.emplace(group, std::move(*solved)).first;
            }
            known = &found->second;
        }
        for (const std::size_t row : report.rows) {
            const RangeMeasurement& measured = table.ranges[row];
            const auto index = anchors.indexOf(measured.anchor);
            if (!index) {
                ++prepared.m_unknown[measured.anchor];
                continue;
            }
            const UwbAnchor& anchor = anchors.anchors[static_cast<std::size_t>(*index)];
            AnchorRange range;
            range.anchor = {anchor.x, anchor.y, anchor.z};
            range.range_m = measured.range_m;
            range.index = *index;
            const std::pair pair(measured.tag, measured.anchor);
            if (const auto added = anchors.corrections_m.find(pair); added != anchors.corrections_m.end())
                range.range_m += added->second;
            if (known != nullptr) {
                const auto bias = known->find(pair);
                if (bias != known->end()) {
                    range.range_m = bias->second.corrected(range.range_m);
                    range.sd_m = sdOf(bias->second);
                } else {
                    ++prepared.m_uncalibrated;
                }
            }
            if (range.range_m > 0.0)
                prepared.m_ranges.push_back(range);
        }
    }
    prepared.m_first.push_back(prepared.m_ranges.size());
    return prepared;
}

namespace {

Result<std::vector<ReportFix>> runAutomatic(const PreparedRanges& ranges, const MethodSettings& settings)
{
    auto fixes = runMethod(methodOfMoving, ranges, settings, nullptr);
    const auto standing = runMethod(methodOfStanding, ranges, settings, nullptr);
    if (!fixes || !standing)
        return fixes ? standing : fixes;
    std::vector<std::vector<std::size_t>> reports(ranges.list().tracks);
    for (std::size_t k = 0; k < fixes->size(); ++k)
        reports[ranges.list().reports[k].track].push_back(k);
    for (const std::vector<std::size_t>& track : reports) {
        const ReportFix& last = (*standing)[track.back()];
        if (last.ok() && stands(ranges, track, last.position))
            for (const std::size_t report : track)
                (*fixes)[report] = (*standing)[report];
    }
    return fixes;
}

} // namespace

Result<std::vector<ReportFix>> runMethod(std::string_view method, const PreparedRanges& ranges,
                                         const MethodSettings& settings, const VehicleData* vehicle)
{
    if (method == automaticMethod)
        return runAutomatic(ranges, settings);
    std::vector<Track> tracks(ranges.list().tracks);
    std::vector<ReportFix> fixes;
    fixes.reserve(ranges.list().reports.size());
    for (std::size_t k = 0; k < ranges.list().reports.size(); ++k) {
        const UwbReport& report = ranges.list().reports[k];
        Track& track = tracks[report.track];
        if (!track.locator) {
            estimation::LocatorSettings own{.anchors = settings.anchors,
                                            .height_m = settings.heights_m[report.track],
                                            .seed = settings.seed};
            if (vehicle != nullptr) {
                own.startPose = vehicle->startPose;
                own.startHeading = vehicle->startHeading;
                own.mount = vehicle->mountOf(report.tag);
                track.vehicle.emplace(*vehicle);
            }
            auto made = estimation::makeLocator(method, own);
            if (!made)
                return std::unexpected(made.error());
            track.locator = std::move(*made);
        }
        if (track.vehicle)
            track.vehicle->advance(*track.locator, report.time_s);
        fixes.push_back(fixFrom(track.locator->locate(report.time_s, ranges.of(k))));
    }
    return fixes;
}

} // namespace agv::app
