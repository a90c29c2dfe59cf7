// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/rssi_branch.h"

#include "estimation/classic/turn_vectors.h"

#include <gtest/gtest.h>

namespace agv::estimation {
namespace {

TEST(RssiBranch, distancesOfTheMeasuredTableAreThoseOfThePublishedProgram)
{
    const auto published = test::readVector("rssi_table.json")["seed_dist_cm"];
    const std::array<std::pair<RssiBranch, const char*>, 3> branches{
        {{RssiBranch::Far, "max"}, {RssiBranch::Middle, "mid"}, {RssiBranch::Near, "min"}}};
    for (const auto& [branch, name] : branches) {
        for (int rssi = 0; rssi <= 7; ++rssi) {
            const auto found = branchDistance(seedRssiTable(), rssi, branch);
            ASSERT_TRUE(found.has_value());
            EXPECT_NEAR(*found * 100.0, published[name][static_cast<std::size_t>(rssi)].get<double>(), 1e-9)
                << name << " " << rssi;
        }
    }
}

TEST(RssiBranch, ofAnRssiThatTheTableLacksIsEmpty)
{
    EXPECT_FALSE(branchDistance({{0.1, 0}}, 3, RssiBranch::Near).has_value());
    EXPECT_FALSE(branchDistance({}, 0, RssiBranch::Far).has_value());
}

TEST(RssiBranch, followsTheShapeOfThePattern)
{
    using enum RssiBranch;
    const auto choose = [](std::vector<int> neighbours, std::vector<int> rssi) {
        return chooseBranches(neighbours, rssi);
    };
    const std::vector<int> zeros(9, 0);
    EXPECT_EQ(choose({1, 0, 1}, {0, 0, 0}), (std::vector{Far, Middle, Far}));
    EXPECT_EQ(choose({2, 2, 2, 2}, {4, 4, 4, 4}), (std::vector(4, Far)));
    EXPECT_EQ(choose({1, 1, 3, 1, 0}, zeros), (std::vector{Far, Far, Middle, Far, Far}));
    EXPECT_EQ(choose({2, 2, 4, 2, 1, 1}, {0, 0, 3, 0, 0, 0}), (std::vector{Far, Far, Near, Far, Far, Far}));
    EXPECT_EQ(choose({2, 2, 4, 2, 1, 1}, {0, 0, 4, 0, 0, 0}), (std::vector{Far, Far, Middle, Far, Far, Far}));
    EXPECT_EQ(choose({2, 3, 2, 2, 3, 2}, {0, 5, 0, 0, 0, 0}), (std::vector{Far, Near, Far, Far, Near, Far}));
    EXPECT_EQ(choose({2, 2, 4, 2, 2, 1, 1}, zeros), (std::vector{Far, Far, Near, Far, Far, Far, Far}));
    EXPECT_TRUE(choose({}, {}).empty());
}

} // namespace
} // namespace agv::estimation
