// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/tag_floor.h"

#include <algorithm>

namespace agv::simulation {
namespace {

std::unexpected<Error> noSuchTag(TagUid uid)
{
    return failure(ErrorCode::NotFound, "the plant has no floor tag " + fullText(uid));
}

} // namespace

TagFloor::TagFloor(const std::vector<FloorTag>& planned, double errorSd_m, SplitMix64 random)
{
    m_tags.reserve(planned.size());
    for (const FloorTag& tag : planned) {
        const double dx = errorSd_m * random.normal();
        const double dy = errorSd_m * random.normal();
        m_tags.push_back({tag.uid, tag.position + Point2{dx, dy}});
    }
    m_healthy = m_tags;
}

std::vector<std::size_t> TagFloor::within(Point2 centre, double range_m) const
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < m_tags.size(); ++i)
        if (!m_tags[i].dead && distance(m_tags[i].position, centre) <= range_m)
            found.push_back(i);
    return found;
}

TagFloor::Tag* TagFloor::find(TagUid uid)
{
    const auto found = std::ranges::find(m_tags, uid, &Tag::uid);
    return found == m_tags.end() ? nullptr : &*found;
}

Result<void> TagFloor::kill(TagUid uid)
{
    Tag* tag = find(uid);
    if (!tag)
        return noSuchTag(uid);
    tag->dead = true;
    return {};
}

std::vector<TagUid> TagFloor::killRandom(std::size_t count, SplitMix64& random)
{
    std::vector<std::size_t> live;
    for (std::size_t i = 0; i < m_tags.size(); ++i)
        if (!m_tags[i].dead)
            live.push_back(i);
    std::vector<TagUid> killed;
    while (killed.size() < count && !live.empty()) {
        const std::size_t pick = random.next() % live.size();
        m_tags[live[pick]].dead = true;
        killed.push_back(m_tags[live[pick]].uid);
        live[pick] = live.back();
        live.pop_back();
    }
    return killed;
}

Result<void> TagFloor::swap(TagUid first, TagUid second)
{
    Tag* a = find(first);
    Tag* b = find(second);
    if (!a || !b)
        return noSuchTag(a ? second : first);
    std::swap(a->position, b->position);
    return {};
}

void TagFloor::restore() { m_tags = m_healthy; }

} // namespace agv::simulation
