// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/stop_antenna.h"

#include "estimation/classic/circle_geometry.h"
#include "estimation/classic/rssi_branch.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace agv::estimation {

namespace {

/// Three tags flatter than this count as collinear. Triples of a grid within reach of the antenna have 0.2 or
/// more; surveyed "collinear" ones a few per cent, and would magnify a radius error twenty times.
constexpr double leastFlatness = 0.1;

/// Bounds the search for three tags; no antenna reaches nearly as many.
constexpr std::size_t mostTags = 40;

struct ReadCount {
    TagUid uid;
    std::map<int, int> readsByRssi;
    std::vector<int> order; ///< RSSI values by first appearance
};

int mostFrequentRssi(const ReadCount& tag)
{
    return *std::ranges::max_element(tag.order, {},
                                     [&](int rssi) { return tag.readsByRssi.at(rssi); }); // the first maximum
}

} // namespace

std::vector<TagAtStop> tagsAtStop(const TurnStop& stop, const TagMap& positions)
{
    std::vector<ReadCount> tags;
    for (const TagRead& read : stop.reads) {
        if (!positions.contains(read.uid))
            continue;
        auto tag = std::ranges::find(tags, read.uid, &ReadCount::uid);
        if (tag == tags.end())
            tag = tags.insert(tags.end(), ReadCount{read.uid, {}, {}});
        if (tag->readsByRssi[read.rssi]++ == 0)
            tag->order.push_back(read.rssi);
    }
    std::vector<TagAtStop> result;
    result.reserve(tags.size());
    for (const ReadCount& tag : tags)
        result.push_back({tag.uid, positions.at(tag.uid), mostFrequentRssi(tag)});
    return result;
}

double tagPitch(std::span<const TagAtStop> some, std::span<const FloorTag> all)
{
    std::vector<double> nearest;
    for (const TagAtStop& tag : some) {
        double best = std::numeric_limits<double>::infinity();
        for (const FloorTag& other : all) {
            const double apart = distance(tag.position, other.position);
            if (apart > 0.0)
                best = std::min(best, apart);
        }
        if (std::isfinite(best))
            nearest.push_back(best);
    }
    if (nearest.empty())
        return 0.0;
    const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
    std::ranges::nth_element(nearest, middle);
    return *middle;
}

std::vector<int> neighbourCounts(std::span<const TagAtStop> tags, double pitch)
{
    const auto areNeighbours = [=](const TagAtStop& a, const TagAtStop& b) {
        return std::abs(distance(a.position, b.position) - pitch) < 0.25 * pitch;
    };
    std::vector<int> counts;
    counts.reserve(tags.size());
    for (const TagAtStop& tag : tags) {
        counts.push_back(static_cast<int>(
            std::ranges::count_if(tags, [&](const TagAtStop& other) { return areNeighbours(tag, other); })));
    }
    return counts;
}

std::optional<Point2> antennaFromShape(std::span<const TagAtStop> tags, double pitch, const RssiTable& table)
{
    const std::vector<int> neighbours = neighbourCounts(tags, pitch);
    std::vector<int> rssi(tags.size());
    std::ranges::transform(tags, rssi.begin(), &TagAtStop::rssi);
    const std::vector<RssiBranch> branches = chooseBranches(neighbours, rssi);

    std::vector<Circle> circles;
    std::vector<std::size_t> order(tags.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t tag) { return neighbours[tag]; });
    for (const std::size_t tag : order) {
        if (circles.size() == mostTags)
            break;
        if (const auto radius = branchDistance(table, rssi[tag], branches[tag]))
            circles.push_back({tags[tag].position, *radius});
    }

    for (std::size_t a = 0; a < circles.size(); ++a) {
        for (std::size_t b = a + 1; b < circles.size(); ++b) {
            for (std::size_t c = b + 1; c < circles.size(); ++c) {
                if (flatness(circles[a].centre, circles[b].centre, circles[c].centre) < leastFlatness)
                    continue;
                if (const auto antenna = trilaterate({circles[a], circles[b], circles[c]}))
                    return *antenna;
            }
        }
    }
    return std::nullopt;
}

} // namespace agv::estimation
