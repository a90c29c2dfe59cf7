// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/anchor_statistics.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <array>

namespace agv::session {
namespace {

using namespace std::chrono_literals;

constexpr Time begin{100s};

std::vector<UwbAnchor> twoAnchors()
{
    return {{7, "A7", 0.0, 0.0, 2.0, true}, {2, "A2", 3.0, 0.0, 2.0, true}};
}

UwbAnchorSnapshot nothingOf(int anchor)
{
    UwbAnchorSnapshot snapshot;
    snapshot.id = anchor;
    return snapshot;
}

void addResidual(AnchorStatistics& statistics, int anchor, std::optional<double> residual_m)
{
    const std::array<UwbRangeSnapshot, 1> range{UwbRangeSnapshot{anchor, 3.0, residual_m, false}};
    statistics.add(range);
}

TEST(AnchorStatistics, ListsEveryAnchorOfThePlantInItsOrderAlsoBeforeItRanges)
{
    AnchorStatistics statistics(twoAnchors());
    const std::vector<UwbAnchorSnapshot> anchors = statistics.snapshot(begin);
    ASSERT_EQ(anchors.size(), 2U);
    EXPECT_EQ(anchors[0], nothingOf(7));
    EXPECT_EQ(anchors[1], nothingOf(2));
}

TEST(AnchorStatistics, CountsTheRangesOfEachAnchorAndTellsTheAgeOfTheLast)
{
    AnchorStatistics statistics(twoAnchors());
    for (int i = 0; i < 50; ++i)
        statistics.heard(2, begin + i * 100ms, begin + i * 100ms - 80ms);
    statistics.heard(5, begin, begin); // not of the plant
    const std::vector<UwbAnchorSnapshot> anchors = statistics.snapshot(begin + 5s);
    EXPECT_EQ(anchors[0].rangesPerSecond, 0.0);
    EXPECT_FALSE(anchors[0].age_s);
    EXPECT_NEAR(anchors[1].rangesPerSecond, 10.0, 0.6);
    EXPECT_NEAR(anchors[1].age_s.value(), 0.18, 1e-9);
}

TEST(AnchorStatistics, TheResidualIsThatOfTheLastTwoHundredRangesWithAPosition)
{
    AnchorStatistics statistics(twoAnchors());
    SplitMix64 random(3);
    for (int i = 0; i < 1000; ++i)
        addResidual(statistics, 7, 5.0);
    for (std::size_t i = 0; i < AnchorStatistics::residualsKept; ++i) {
        addResidual(statistics, 7, 0.12 + 0.03 * random.normal());
        addResidual(statistics, 7, std::nullopt);
    }
    const std::optional<ResidualSummary> residual = statistics.snapshot(begin)[0].residual;
    ASSERT_TRUE(residual);
    EXPECT_EQ(residual->count, 200);
    EXPECT_NEAR(residual->mean_m, 0.12, 0.01);
    EXPECT_NEAR(residual->sd_m, 0.03, 0.005);
}

TEST(AnchorStatistics, AFewRangesGiveNoResidualYet)
{
    AnchorStatistics statistics(twoAnchors());
    for (std::size_t i = 0; i + 1 < AnchorStatistics::leastResiduals; ++i)
        addResidual(statistics, 2, 0.125);
    EXPECT_FALSE(statistics.snapshot(begin)[1].residual);
    addResidual(statistics, 2, 0.125);
    EXPECT_EQ(statistics.snapshot(begin)[1].residual, (ResidualSummary{0.125, 0.0, 20}));
}

TEST(AnchorStatistics, AnchorsThatStayInTheEditedListKeepTheirRateAndAge)
{
    AnchorStatistics statistics(twoAnchors());
    for (int i = 0; i < 20; ++i)
        statistics.heard(2, begin + i * 100ms, begin + i * 100ms);
    statistics.setAnchors({{2, "B", 3.5, 0.0, 2.0, true}, {9, "C", 0.0, 0.0, 2.0, true}});
    const std::vector<UwbAnchorSnapshot> anchors = statistics.snapshot(begin + 2s);
    ASSERT_EQ(anchors.size(), 2U);
    EXPECT_EQ(anchors[0].id, 2);
    EXPECT_GT(anchors[0].rangesPerSecond, 9.0);
    EXPECT_EQ(anchors[1], nothingOf(9));
}

} // namespace
} // namespace agv::session
