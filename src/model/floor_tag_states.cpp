// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/floor_tag_states.h"

#include <algorithm>
#include <cmath>

namespace agv::model {
namespace {

/// An AGV that was moved by more no longer stands where its turn was.
constexpr double stands_m = 0.02;
constexpr double stands = 0.1; ///< rad

bool standsThere(const AgvSnapshot& agv, const Pose2& pose)
{
    return !agv.pose || (distance(agv.pose->position, pose.position) < stands_m &&
                         std::abs(wrapAngle(agv.pose->heading - pose.heading)) < stands);
}

} // namespace

const TurnEstimate* shownEstimate(const AgvSnapshot& agv)
{
    const TurnEstimate* result = agv.turn.result.get();
    const TurnEstimate* estimate = result ? result : agv.turn.preview.get();
    if (!estimate || !estimate->valid || (result && !standsThere(agv, result->pose)))
        return nullptr;
    return estimate;
}

void FloorTagStates::clear() { *this = FloorTagStates(); }

void FloorTagStates::add(const PlantSnapshot& snapshot)
{
    m_time = snapshot.time;
    m_missing.clear();
    m_unknown.clear();
    for (const AgvSnapshot& agv : snapshot.agvs) {
        for (const TagRead& read : agv.recentReads) {
            m_seen.insert(read.uid);
            LastRead& last = m_reads[read.uid];
            if (read.time >= last.time)
                last = {read.time, agv.id.number, read.rssi};
        }
        const TurnEstimate* estimate = shownEstimate(agv);
        if (!estimate)
            continue;
        for (const StopReport& stop : estimate->stops) {
            m_seen.insert(stop.seen.begin(), stop.seen.end());
            m_missing.insert(stop.missed.begin(), stop.missed.end());
            for (const TagUid uid : stop.unknown) {
                if (std::ranges::find(m_unknown, uid, &Unknown::uid) == m_unknown.end())
                    m_unknown.push_back({uid, stop.antenna});
            }
        }
    }
    // Missed at one stop and read at another one: it is there.
    std::erase_if(m_missing, [this](TagUid uid) { return m_seen.contains(uid); });
}

FloorTagState FloorTagStates::stateOf(TagUid uid) const
{
    if (m_missing.contains(uid))
        return FloorTagState::Missing;
    if (!m_seen.contains(uid))
        return FloorTagState::NotSeen;
    const std::optional<LastRead> last = lastRead(uid);
    return last && m_time - last->time <= now ? FloorTagState::SeenNow : FloorTagState::SeenBefore;
}

std::optional<FloorTagStates::LastRead> FloorTagStates::lastRead(TagUid uid) const
{
    const auto found = m_reads.find(uid);
    return found == m_reads.end() ? std::nullopt : std::optional(found->second);
}

} // namespace agv::model
