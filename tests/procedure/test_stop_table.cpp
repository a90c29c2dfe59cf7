// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/stop_table.h"

#include <gtest/gtest.h>

namespace agv::procedure {
namespace {

TurnStop stopOf(std::vector<std::pair<std::uint64_t, int>> reads)
{
    TurnStop stop;
    for (const auto& [uid, rssi] : reads)
        stop.reads.push_back({Time{}, TagUid{uid}, rssi});
    return stop;
}

using Tags = std::vector<std::pair<TagUid, int>>;

TEST(StopTable, ListsTagsInOrderOfTheirFirstRead)
{
    const StopRow row = stopRow(4, stopOf({{7, 1}, {3, 2}, {7, 1}}), true);
    EXPECT_EQ(row.tags, (Tags{{TagUid{7}, 1}, {TagUid{3}, 2}}));
    EXPECT_EQ(row.stop, 4);
    EXPECT_EQ(row.reads, 3);
    EXPECT_TRUE(row.done);
}

TEST(StopTable, ShowsTheMostFrequentRssi)
{
    EXPECT_EQ(stopRow(1, stopOf({{1, 5}, {1, 2}, {1, 2}}), false).tags, (Tags{{TagUid{1}, 2}}));
}

TEST(StopTable, ShowsTheStrongerOfTwoEquallyFrequentRssi)
{
    EXPECT_EQ(stopRow(1, stopOf({{1, 2}, {1, 5}}), false).tags, (Tags{{TagUid{1}, 5}}));
}

TEST(StopTable, IsEmptyWithoutReads) { EXPECT_TRUE(stopRow(1, {}, true).tags.empty()); }

TEST(StopTable, TakesAnyNumberOfTags)
{
    TurnStop stop;
    for (unsigned uid = 1; uid <= 40; ++uid)
        stop.reads.push_back({Time{}, TagUid{uid}, 0});
    EXPECT_EQ(stopRow(1, stop, true).tags.size(), 40U);
}

} // namespace
} // namespace agv::procedure
