// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/turn_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

namespace agv::estimation {

namespace {

constexpr std::size_t kMaxStops = 64;
constexpr double kSmallestRadius_m = 0.005; ///< a smaller circle says nothing about the heading
constexpr double kLargestRadius_m = 2.0;
constexpr double kLargestCoordinate_m = 1e5;
constexpr double kReachMargin = 1.2;       ///< the true reach may exceed the table's
constexpr double kSearchHalf_m = 0.12;     ///< the mean of many tags is this near to the centre
constexpr int kTagsForNarrowSearch = 16;   ///< ... when at least this many tags
constexpr int kStopsForNarrowSearch = 5;   ///< ... at this many stops were read
constexpr std::size_t kMostNearTags = 400; ///< a denser map is thinned to the nearest

struct TagReads {
    std::array<int, 8> counts{};
    int total = 0;
};

/// Reads of a stop by tag, in order of first read.
struct ReadsByTag {
    std::vector<TagUid> order;
    std::unordered_map<TagUid, TagReads> tags;
};

ReadsByTag readsByTag(const TurnStop& stop)
{
    ReadsByTag result;
    for (const TagRead& read : stop.reads) {
        if (read.rssi < 0 || read.rssi > 7)
            continue;
        TagReads& tag = result.tags[read.uid];
        if (tag.total == 0)
            result.order.push_back(read.uid);
        ++tag.counts[static_cast<std::size_t>(read.rssi)];
        ++tag.total;
    }
    return result;
}

bool usable(Point2 p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::abs(p.x) < kLargestCoordinate_m &&
           std::abs(p.y) < kLargestCoordinate_m;
}

TagMap usableTags(const std::vector<FloorTag>& tags)
{
    TagMap map;
    map.reserve(tags.size());
    for (const FloorTag& tag : tags)
        if (usable(tag.position))
            map.emplace(tag.uid, tag.position);
    return map;
}

/// A tag read in the turn, weighted with the number of stops it was read at.
struct Sighting {
    Point2 position;
    double weight = 0.0;
};

std::vector<Sighting> sightingsOf(const std::vector<ReadsByTag>& stops, const TagMap& map)
{
    std::unordered_map<TagUid, std::size_t> indexOf;
    std::vector<Sighting> sightings;
    for (const ReadsByTag& stop : stops) {
        for (const TagUid uid : stop.order) {
            const auto place = map.find(uid);
            if (place == map.end())
                continue;
            const auto [entry, isNew] = indexOf.emplace(uid, sightings.size());
            if (isNew)
                sightings.push_back({place->second, 0.0});
            sightings[entry->second].weight += 1.0;
        }
    }
    return sightings;
}

double weightWithin(const std::vector<Sighting>& sightings, Point2 middle, double radius_m)
{
    double sum = 0.0;
    for (const Sighting& s : sightings)
        if (distance(s.position, middle) <= radius_m)
            sum += s.weight;
    return sum;
}

Point2 meanWithin(const std::vector<Sighting>& sightings, Point2 middle, double radius_m)
{
    Point2 sum;
    double weight = 0.0;
    for (const Sighting& s : sightings) {
        if (distance(s.position, middle) > radius_m)
            continue;
        sum = sum + s.weight * s.position;
        weight += s.weight;
    }
    return weight > 0.0 ? (1.0 / weight) * sum : middle;
}

/// Middle of the densest group of sightings; a tag whose place in the map is wrong does not pull it.
Point2 middleOf(const std::vector<Sighting>& sightings, double span_m)
{
    constexpr std::size_t kMostSeeds = 500; // a turn reads some dozens of tags; more is not a turn
    const std::size_t stride = 1 + sightings.size() / kMostSeeds;
    Point2 best = sightings.front().position;
    double bestWeight = -1.0;
    for (std::size_t i = 0; i < sightings.size(); i += stride) {
        const double weight = weightWithin(sightings, sightings[i].position, span_m);
        if (weight > bestWeight) {
            bestWeight = weight;
            best = sightings[i].position;
        }
    }
    return meanWithin(sightings, meanWithin(sightings, best, span_m), span_m);
}

void addReadTerms(const TagReads& reads, Point2 at, StopEvidence& stop)
{
    const double effective = reads.total / (1.0 + (reads.total - 1) * kReadCorrelation);
    for (int rssi = 0; rssi < 8; ++rssi) {
        const int count = reads.counts[static_cast<std::size_t>(rssi)];
        if (count > 0)
            stop.terms.push_back({static_cast<float>(at.x), static_cast<float>(at.y), rssi,
                                  static_cast<float>(effective * count / reads.total)});
    }
}

void addReads(const ReadsByTag& reads, const TagMap& map, Point2 origin, double farthest_m,
              StopEvidence& stop)
{
    for (const TagUid uid : reads.order) {
        const auto place = map.find(uid);
        if (place == map.end()) {
            stop.unknown.push_back(uid);
            continue;
        }
        const Point2 at = place->second - origin;
        if (std::hypot(at.x, at.y) > farthest_m) {
            stop.misplaced.push_back(uid);
            continue;
        }
        const TagReads& tag = reads.tags.at(uid);
        addReadTerms(tag, at, stop);
        stop.meanOfRead = stop.meanOfRead + at;
        stop.reads += tag.total;
        ++stop.tagsRead;
    }
    stop.readTerms = stop.terms.size();
    if (stop.tagsRead > 0)
        stop.meanOfRead = (1.0 / stop.tagsRead) * stop.meanOfRead;
}

/// The antenna is within reach of the tags it read, so farther tags cannot matter at this stop.
void addUnread(const std::vector<NearTag>& nearTags, const ReadsByTag& reads,
               const std::vector<TagUid>& unknownIfUnseen, double reach_m, StopEvidence& stop)
{
    const std::unordered_set<TagUid> silent(unknownIfUnseen.begin(), unknownIfUnseen.end());
    for (const NearTag& tag : nearTags) {
        if (reads.tags.contains(tag.uid) || silent.contains(tag.uid))
            continue;
        if (stop.tagsRead > 0 && distance(tag.position, stop.meanOfRead) > 2.0 * kReachMargin * reach_m)
            continue;
        stop.terms.push_back(
            {static_cast<float>(tag.position.x), static_cast<float>(tag.position.y), kNotRead, 1.0F});
    }
}

std::vector<NearTag> tagsNear(const std::vector<FloorTag>& tags, const TagMap& map, Point2 origin,
                              double radius_m)
{
    std::vector<NearTag> near;
    std::unordered_set<TagUid> taken;
    for (const FloorTag& tag : tags) {
        if (!usable(tag.position) || distance(tag.position, origin) > radius_m ||
            !taken.insert(tag.uid).second)
            continue;
        near.push_back({tag.uid, map.at(tag.uid) - origin});
    }
    if (near.size() > kMostNearTags) {
        const auto nearer = [](const NearTag& a, const NearTag& b) {
            return std::pair(std::hypot(a.position.x, a.position.y), a.uid) <
                   std::pair(std::hypot(b.position.x, b.position.y), b.uid);
        };
        std::sort(near.begin(), near.end(), nearer);
        near.resize(kMostNearTags);
    }
    return near;
}

/// Compares the tags read with those in reach of antennas all around the origin.
double roughlyMissed(const TurnEvidence& evidence, double reach_m)
{
    constexpr int kPlaces = 16;
    int inReach = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const double a = 2.0 * std::numbers::pi * i / kPlaces;
        const Point2 antenna{evidence.radius_m * std::cos(a), evidence.radius_m * std::sin(a)};
        for (const NearTag& tag : evidence.nearTags)
            inReach += distance(tag.position, antenna) <= reach_m ? 1 : 0;
    }
    const double perStop = static_cast<double>(inReach) / kPlaces;
    const double expected = perStop * static_cast<double>(evidence.stops.size());
    return expected > 0.0 ? std::clamp(1.0 - evidence.tagsRead / expected, 0.0, 1.0) : 0.0;
}

std::string inputProblem(const TurnRecord& record, const TurnContext& context)
{
    if (const std::string table = problemOf(context.rssiTable); !table.empty())
        return table;
    if (!std::isfinite(record.nominalStep) || record.nominalStep < radFromDeg(1.0) ||
        record.nominalStep > radFromDeg(120.0))
        return "step_out_of_range";
    const double radius = std::hypot(context.antenna.x, context.antenna.y);
    if (!(radius >= kSmallestRadius_m && radius <= kLargestRadius_m))
        return "antenna_out_of_range";
    if (record.stops.size() > kMaxStops)
        return "too_many_stops";
    return {};
}

} // namespace

std::variant<TurnEvidence, std::string> prepareEvidence(const TurnRecord& record, const TurnContext& context)
{
    if (std::string problem = inputProblem(record, context); !problem.empty())
        return problem;
    std::vector<ReadsByTag> reads;
    for (const TurnStop& stop : record.stops)
        reads.push_back(readsByTag(stop));
    const TagMap map = usableTags(context.tags);
    const std::vector<Sighting> sightings = sightingsOf(reads, map);
    if (sightings.empty())
        return std::string("no_reads");

    TurnEvidence evidence;
    evidence.nominalStep = record.nominalStep;
    evidence.radius_m = std::hypot(context.antenna.x, context.antenna.y);
    evidence.antennaBearing = std::atan2(context.antenna.y, context.antenna.x);
    const double reach_m = context.rssiTable.front().upperEdge;
    const double span_m = evidence.radius_m + kReachMargin * reach_m;
    evidence.origin = middleOf(sightings, span_m + kSearchHalf_m);
    for (const ReadsByTag& stopReads : reads) {
        StopEvidence stop;
        addReads(stopReads, map, evidence.origin, span_m + kSearchHalf_m, stop);
        evidence.tagsRead += stop.tagsRead;
        evidence.stopsWithReads += stop.tagsRead > 0 ? 1 : 0;
        evidence.stops.push_back(std::move(stop));
    }
    const bool narrow =
        evidence.tagsRead >= kTagsForNarrowSearch && evidence.stopsWithReads >= kStopsForNarrowSearch;
    evidence.searchHalf_m = narrow ? kSearchHalf_m : span_m;
    evidence.nearTags =
        tagsNear(context.tags, map, evidence.origin, span_m + std::numbers::sqrt2 * evidence.searchHalf_m);
    evidence.missed = roughlyMissed(evidence, reach_m);
    for (std::size_t k = 0; k < reads.size(); ++k)
        addUnread(evidence.nearTags, reads[k], record.stops[k].unknownIfUnseen, reach_m, evidence.stops[k]);
    return evidence;
}

} // namespace agv::estimation
