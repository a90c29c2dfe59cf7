// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/classic_reports.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

bool contains(const std::vector<TagUid>& tags, TagUid uid)
{
    return std::ranges::find(tags, uid) != tags.end();
}

/// Each UID once, in order of first reading.
std::vector<TagUid> tagsRead(const TurnStop& stop)
{
    std::vector<TagUid> tags;
    for (const TagRead& read : stop.reads) {
        if (!contains(tags, read.uid))
            tags.push_back(read.uid);
    }
    return tags;
}

StopReport reportOfStop(const TurnStop& stop, const TurnContext& context, const TagMap& positions,
                        Point2 antenna, double antennaSd)
{
    StopReport report;
    report.antenna = antenna;
    report.antennaSd_m = antennaSd;
    const double reach = context.rssiTable.empty() ? 0.0 : context.rssiTable.front().upperEdge;
    const std::vector<TagUid> read = tagsRead(stop);
    for (const TagUid uid : read) {
        const auto known = positions.find(uid);
        if (known == positions.end())
            report.unknown.push_back(uid);
        else if (distance(known->second, antenna) > reach + 3.0 * antennaSd)
            report.misplaced.push_back(uid);
        else
            report.seen.push_back(uid);
    }
    for (const FloorTag& tag : context.tags) {
        if (distance(tag.position, antenna) > reach)
            continue;
        report.expected.push_back(tag.uid);
        if (!contains(read, tag.uid) && !contains(stop.unknownIfUnseen, tag.uid))
            report.missed.push_back(tag.uid);
    }
    return report;
}

} // namespace

std::vector<StopReport> reportsWithoutPose(const TurnRecord& record, const TagMap& positions)
{
    std::vector<StopReport> reports;
    reports.reserve(record.stops.size());
    for (const TurnStop& stop : record.stops) {
        StopReport report;
        for (const TagUid uid : tagsRead(stop))
            (positions.contains(uid) ? report.seen : report.unknown).push_back(uid);
        reports.push_back(std::move(report));
    }
    return reports;
}

std::vector<StopReport> reportsAround(const TurnEstimate& estimate, const TurnRecord& record,
                                      const TurnContext& context, const TagMap& positions,
                                      const std::vector<std::optional<Point2>>& antennas, double scatter)
{
    const Point2 centre = estimate.startPose.position;
    const double mounting = std::atan2(context.antenna.y, context.antenna.x);
    const double centreSd = std::sqrt(std::max(estimate.covariance[0], estimate.covariance[4]));
    std::vector<StopReport> reports;
    reports.reserve(record.stops.size());
    for (std::size_t stop = 0; stop < record.stops.size(); ++stop) {
        const double nominal = estimate.startPose.heading + mounting +
                               signOf(estimate.rotation) * static_cast<double>(stop) * record.nominalStep;
        const Point2 onCircle = centre + estimate.radius_m * Point2{std::cos(nominal), std::sin(nominal)};
        const Point2 antenna = antennas[stop].value_or(onCircle);
        const double sd = antennas[stop] ? scatter : std::hypot(scatter, centreSd);
        StopReport report = reportOfStop(record.stops[stop], context, positions, antenna, sd);
        report.antennaBearing = std::atan2(antenna.y - centre.y, antenna.x - centre.x);
        reports.push_back(std::move(report));
    }
    return reports;
}

} // namespace agv::estimation
