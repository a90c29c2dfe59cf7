// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/uwb_kit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace agv::simulation {

namespace {

constexpr Duration slowPeriod = std::chrono::milliseconds(280);
constexpr Duration fastPeriod = std::chrono::milliseconds(100);
constexpr int slotsOfPeriod = 8;
constexpr Duration offAfter = std::chrono::seconds(2);
constexpr double secondsOfMinute = 60.0;

double distance(const UwbAnchor& a, double x, double y, double z)
{
    return std::hypot(a.x - x, a.y - y, a.z - z);
}

} // namespace

UwbKitSettings idealUwbKitSettings(std::vector<UwbAnchor> anchors)
{
    UwbKitSettings settings;
    settings.model = {.noiseSd_m = 0.0,
                      .pairBiasSd_m = 0.0,
                      .missRate = 0.0,
                      .lostRate = 0.0,
                      .nlosPerMinute = 0.0,
                      .reach_m = 1e3};
    settings.anchors = std::move(anchors);
    return settings;
}

std::vector<UwbAnchor> defaultUwbAnchors(const PlantLayout& plant, int count)
{
    constexpr double low_m = 1.3;
    constexpr double high_m = 2.3;
    constexpr std::array<Point2, 8> places{Point2{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0},
                                           {0.5, 0.0},       {1.0, 0.5}, {0.5, 1.0}, {0.0, 0.5}};
    std::vector<UwbAnchor> anchors;
    for (int id = 0; id < std::clamp(count, 0, static_cast<int>(places.size())); ++id) {
        const Point2 share = places[static_cast<std::size_t>(id)];
        anchors.push_back({.id = id,
                           .label = "A" + std::to_string(id),
                           .x = plant.origin.x + share.x * plant.width_m,
                           .y = plant.origin.y + share.y * plant.height_m,
                           .z = id == 1 || id == 2 || id >= 6 ? high_m : low_m});
    }
    return anchors;
}

UwbKit::UwbKit(UwbKitSettings settings, Time start)
    : m_settings(std::move(settings)),
      m_healthy(m_settings.model),
      m_random(m_settings.seed),
      m_start(start),
      m_booted(start),
      m_nextAnchorRanges(start),
      m_silentUntil(start),
      m_portBusyUntil(start)
{
    if (m_settings.dialect == UwbDialect::Unknown)
        m_settings.dialect = UwbDialect::Trek;
    for (const UwbAnchor& place : m_settings.anchors) {
        if (place.id < 0 || static_cast<std::size_t>(place.id) >= rangeCount())
            continue;
        m_anchors[static_cast<std::size_t>(place.id)] = {
            .place = place, .isPresent = true, .blockedUntil = start};
    }
}

Duration UwbKit::period() const { return m_settings.fastMode ? fastPeriod : slowPeriod; }

bool UwbKit::isTrek() const { return !isClone(m_settings.dialect); }

std::size_t UwbKit::rangeCount() const
{
    const bool isEight = m_settings.dialect == UwbDialect::UlmEight ||
                         (m_settings.dialect == UwbDialect::Imu && m_settings.anchors.size() > 4);
    return isEight ? 8 : 4;
}

/// Slots are run in the order of time, so that it does not matter how calls are grouped.
void UwbKit::step(Time now, std::span<const UwbTagPlace> tags)
{
    for (const UwbTagPlace& place : tags)
        if (place.tag >= 0 && place.tag <= 255)
            switchOn(place.tag, now);
    for (;;) {
        const UwbTagPlace* next = nullptr;
        Time at = now;
        for (const UwbTagPlace& place : tags) {
            const auto tag = m_tags.find(place.tag);
            if (tag == m_tags.end() || tag->second.nextSlot > at || (next && tag->second.nextSlot == at))
                continue;
            next = &place;
            at = tag->second.nextSlot;
        }
        if (m_nextAnchorRanges <= at) {
            reportAnchors(m_nextAnchorRanges);
            m_nextAnchorRanges += period();
        } else if (next) {
            runSlot(m_tags.at(next->tag), *next);
        } else {
            break;
        }
    }
    if (m_garbage > 0) {
        std::string bytes;
        for (; m_garbage > 0; --m_garbage)
            bytes += static_cast<char>(m_random.next() & 0xFFU);
        send(bytes, now);
    }
}

/// A tag that is new, or was off, begins with the next slot that is its own.
void UwbKit::switchOn(int id, Time now)
{
    const auto [entry, isNew] = m_tags.try_emplace(id);
    Tag& tag = entry->second;
    if (isNew) {
        tag.random = SplitMix64(m_settings.seed).split(static_cast<std::uint64_t>(id));
        tag.sequence = static_cast<std::uint8_t>(tag.random.next() & 0xFFU);
        for (Pair& pair : tag.pairs) {
            pair.bias_m = m_settings.model.bias_m + m_settings.model.pairBiasSd_m * tag.random.normal();
            pair.burstEnd = m_start;
            pair.nextBurst = m_start + untilBurst(tag.random);
        }
    }
    const bool wasOff = tag.nextSlot + offAfter < now;
    if (!isNew && !wasOff)
        return;
    tag.measured.reset();
    tag.nextSlot = m_start + period() * (id % slotsOfPeriod) / slotsOfPeriod;
    if (tag.nextSlot < now)
        tag.nextSlot += (now - tag.nextSlot + period() - Duration(1)) / period() * period();
}

void UwbKit::runSlot(Tag& tag, const UwbTagPlace& place)
{
    const Time at = tag.nextSlot;
    tag.nextSlot += period();
    const auto previous = static_cast<std::uint8_t>(tag.sequence - 1);
    if (tag.measured && isPlugged(at))
        report(place.tag, *tag.measured, previous, at);
    const bool isLost = tag.random.uniform() < m_settings.model.lostRate;
    tag.measured = measure(tag, place, at);
    if (isLost)
        tag.measured.reset();
    ++tag.sequence;
}

UwbKit::Ranges UwbKit::measure(Tag& tag, const UwbTagPlace& place, Time at)
{
    Ranges ranges{};
    for (std::size_t k = 0; k < rangeCount(); ++k)
        if (m_anchors[k].isPresent)
            ranges[k] = rangeTo(k, tag, place, at);
    return ranges;
}

std::int32_t UwbKit::rangeTo(std::size_t anchor, Tag& tag, const UwbTagPlace& place, Time at)
{
    const UwbRangeModel& model = m_settings.model;
    const Anchor& unit = m_anchors[anchor];
    Pair& pair = tag.pairs[anchor];
    updateBurst(pair, tag.random, at);
    double range_m = distance(unit.place, place.x, place.y, place.z);
    const bool isMissed =
        tag.random.uniform() < model.missRate || !(range_m <= model.reach_m) || unit.isMissing;
    range_m += pair.bias_m + model.noiseSd_m * tag.random.normal();
    if (at < pair.burstEnd)
        range_m += pair.extra_m;
    if (at < unit.blockedUntil)
        range_m += unit.blockedExtra_m;
    return isMissed ? 0 : std::max(1, static_cast<std::int32_t>(std::lround(mmFromMetres(range_m))));
}

void UwbKit::updateBurst(Pair& pair, SplitMix64& random, Time at) const
{
    while (pair.nextBurst <= at) {
        const UwbRangeModel& model = m_settings.model;
        pair.burstEnd = pair.nextBurst + durationFromSeconds(random.exponential(model.nlosDuration_s));
        pair.extra_m = random.uniform(model.nlosLeast_m, model.nlosMost_m);
        pair.nextBurst = pair.burstEnd + untilBurst(random);
    }
}

Duration UwbKit::untilBurst(SplitMix64& random) const
{
    constexpr Duration never = std::chrono::hours(24 * 365);
    if (m_settings.model.nlosPerMinute <= 0.0)
        return never;
    return durationFromSeconds(random.exponential(secondsOfMinute / m_settings.model.nlosPerMinute));
}

void UwbKit::setAnchorMissing(int anchor, bool isMissing)
{
    if (anchor >= 0 && static_cast<std::size_t>(anchor) < mostAnchors)
        m_anchors[static_cast<std::size_t>(anchor)].isMissing = isMissing;
}

void UwbKit::blockAnchor(int anchor, double extra_m, Duration duration, Time now)
{
    if (anchor < 0 || static_cast<std::size_t>(anchor) >= mostAnchors)
        return;
    m_anchors[static_cast<std::size_t>(anchor)].blockedUntil = now + duration;
    m_anchors[static_cast<std::size_t>(anchor)].blockedExtra_m = extra_m;
}

void UwbKit::setMissRate(double share) { m_settings.model.missRate = std::clamp(share, 0.0, 1.0); }

void UwbKit::printGarbage(std::size_t count) { m_garbage += count; }

void UwbKit::unplug(Duration away, Time now)
{
    m_backAt = now + away;
    boot(*m_backAt);
}

/// Power is back on the unit on the port: its clock and settings begin anew.
void UwbKit::boot(Time at)
{
    m_booted = m_silentUntil = m_portBusyUntil = at;
    m_rawReports = true;
    m_command.clear();
    m_output.clear();
}

void UwbKit::restore(Time now)
{
    m_settings.model = m_healthy;
    for (Anchor& anchor : m_anchors) {
        anchor.isMissing = false;
        anchor.blockedUntil = m_start;
    }
    m_garbage = 0;
    if (!isPlugged(now))
        boot(now);
    m_backAt.reset();
}

} // namespace agv::simulation
