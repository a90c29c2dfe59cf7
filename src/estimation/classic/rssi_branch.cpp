// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/rssi_branch.h"

#include <numeric>

namespace agv::estimation {

namespace {

RssiBranch branchInPatternOfFour(int neighbours)
{
    // Appendix K says "stay max" for an outlier without neighbours, but sets the middle value.
    return neighbours == 0 || neighbours == 4 ? RssiBranch::Middle : RssiBranch::Far;
}

RssiBranch branchInPatternOfSix(int neighbours, int sumOfNeighbours, int rssi)
{
    constexpr int sumWithTwoOutliers = 12;
    constexpr int sumOfDomino = 14;
    if (sumOfNeighbours == sumWithTwoOutliers && neighbours == 4)
        return rssi <= 3 ? RssiBranch::Near : RssiBranch::Middle;
    if (sumOfNeighbours == sumOfDomino && neighbours == 3)
        return RssiBranch::Near;
    return RssiBranch::Far;
}

} // namespace

std::optional<double> branchDistance(const RssiTable& table, int rssi, RssiBranch branch)
{
    std::optional<double> found;
    int index = 0;
    for (const RssiStep& step : table) {
        if (step.rssi != rssi)
            continue;
        found = step.upperEdge;
        if (index == static_cast<int>(branch))
            break;
        ++index;
    }
    return found;
}

std::vector<RssiBranch> chooseBranches(std::span<const int> neighbours, std::span<const int> rssi)
{
    std::vector<RssiBranch> branches(neighbours.size(), RssiBranch::Far);
    const int sum = std::accumulate(neighbours.begin(), neighbours.end(), 0);
    for (std::size_t tag = 0; tag < neighbours.size(); ++tag) {
        const int count = neighbours[tag];
        switch (neighbours.size()) {
        case 0:
        case 1:
        case 2:
            break;
        case 3:
        case 4:
            branches[tag] = branchInPatternOfFour(count);
            break;
        case 5:
            branches[tag] = count == 3 ? RssiBranch::Middle : RssiBranch::Far;
            break;
        case 6:
            branches[tag] = branchInPatternOfSix(count, sum, rssi[tag]);
            break;
        default:
            branches[tag] = count == 4 ? RssiBranch::Near : RssiBranch::Far;
        }
    }
    return branches;
}

} // namespace agv::estimation
