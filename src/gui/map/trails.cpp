// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/trails.h"

#include <algorithm>

namespace agv::gui {
namespace {

const Trails::Trail& found(const std::map<int, Trails::Trail>& trails, int id)
{
    static const Trails::Trail none;
    const auto entry = trails.find(id);
    return entry == trails.end() ? none : entry->second;
}

} // namespace

void Trails::clear()
{
    m_tags.clear();
    m_agvs.clear();
}

const Trails::Trail& Trails::ofTag(int tag) const { return found(m_tags, tag); }
const Trails::Trail& Trails::ofAgv(int robot) const { return found(m_agvs, robot); }

void Trails::add(const PlantSnapshot& snapshot)
{
    static const std::vector<UwbTagSnapshot> noTags;
    const std::vector<UwbTagSnapshot>& tags = snapshot.uwb ? snapshot.uwb->tags : noTags;
    std::erase_if(m_tags, [&](const auto& entry) {
        return std::ranges::find(tags, entry.first, &UwbTagSnapshot::id) == tags.end();
    });
    for (const UwbTagSnapshot& tag : tags) {
        if (tag.position)
            addTo(m_tags[tag.id], snapshot.time, *tag.position);
    }
    for (const AgvSnapshot& agv : snapshot.agvs) {
        if (agv.pose && agv.poseHealth != PoseHealth::Doubted)
            addTo(m_agvs[agv.id.number], snapshot.time, agv.pose->position);
    }
    for (auto* trails : {&m_tags, &m_agvs}) {
        for (auto& [id, trail] : *trails)
            prune(trail, snapshot.time);
    }
}

void Trails::addTo(Trail& trail, Time time, Point2 place) const
{
    const double step = trail.empty() ? 0.0 : distance(trail.back().place, place);
    if (!trail.empty() && step < spacing_m)
        return;
    trail.push_back({time, place, trail.empty() || step > longestStep_m});
}

void Trails::prune(Trail& trail, Time now) const
{
    while (trail.size() > mostPoints)
        trail.pop_front();
    if (m_limit.seconds) {
        while (!trail.empty() && secondsFrom(now - trail.front().time) > *m_limit.seconds)
            trail.pop_front();
    }
    if (!m_limit.metres)
        return;
    double length = 0.0;
    for (std::size_t i = trail.size(); i-- > 1;) {
        length += trail[i].startsAnew ? 0.0 : distance(trail[i].place, trail[i - 1].place);
        if (length > *m_limit.metres) {
            trail.erase(trail.begin(), trail.begin() + static_cast<std::ptrdiff_t>(i));
            return;
        }
    }
}

} // namespace agv::gui
