// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/stop_table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace agv::procedure {
namespace {

constexpr std::size_t rssiLevels = 8;
using Histogram = std::array<int, rssiLevels>;

int mostFrequent(const Histogram& histogram)
{
    const auto strongestFirst = std::max_element(histogram.rbegin(), histogram.rend());
    return static_cast<int>(std::distance(strongestFirst, histogram.rend())) - 1;
}

} // namespace

StopRow stopRow(int stop, const TurnStop& reads, bool done)
{
    std::vector<std::pair<TagUid, Histogram>> tags;
    for (const TagRead& read : reads.reads) {
        auto tag = std::ranges::find(tags, read.uid, [](const auto& entry) { return entry.first; });
        if (tag == tags.end())
            tag = tags.insert(tags.end(), {read.uid, Histogram{}});
        const auto level = static_cast<std::size_t>(std::clamp(read.rssi, 0, int(rssiLevels) - 1));
        ++tag->second[level];
    }
    StopRow row{stop, {}, static_cast<int>(reads.reads.size()), done};
    row.tags.reserve(tags.size());
    for (const auto& [uid, histogram] : tags)
        row.tags.emplace_back(uid, mostFrequent(histogram));
    return row;
}

} // namespace agv::procedure
