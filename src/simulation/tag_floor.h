// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/random.h"

#include <vector>

namespace agv::simulation {

/// The tags as they really lie on the floor: a little off the plan, some dead, some swapped.
class TagFloor {
public:
    struct Tag {
        TagUid uid;
        Point2 position; ///< true, m
        bool dead = false;
    };

    /// Each tag lies N(0, errorSd_m) per axis off its planned position.
    TagFloor(const std::vector<FloorTag>& planned, double errorSd_m, SplitMix64 random);

    const std::vector<Tag>& tags() const { return m_tags; }
    /// Indices of the live tags within `range_m` (inclusive) of a point, in the order of the plant file.
    std::vector<std::size_t> within(Point2 centre, double range_m) const;

    /// NotFound: no such tag.
    Result<void> kill(TagUid uid);
    /// Kills `count` live tags chosen at random and returns them (fewer when not so many are left).
    std::vector<TagUid> killRandom(std::size_t count, SplitMix64& random);
    /// The two tags exchange their places. NotFound: no such tag.
    Result<void> swap(TagUid first, TagUid second);
    /// Undoes kill and swap.
    void restore();

private:
    Tag* find(TagUid uid);

    std::vector<Tag> m_tags;
    std::vector<Tag> m_healthy;
};

} // namespace agv::simulation
