// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/published_seed_solver.h"

#include "estimation/classic/turn_vectors.h"

#include <gtest/gtest.h>
#include <set>

namespace agv::estimation {
namespace {

/// Appendix I keeps the 3 x 3 field at 10..30 cm; on the large field the study numbers from the origin.
PublishedSeedSolver solverFor(const nlohmann::json& vector)
{
    const bool small = vector["field"] == "3x3";
    const int size = small ? 3 : 11;
    std::vector<PublishedPoint> positions;
    for (int tag = 0; tag < size * size; ++tag)
        positions.push_back({10 * (tag / size) + (small ? 10 : 0), 10 * (tag % size) + (small ? 10 : 0)});
    return PublishedSeedSolver(std::move(positions));
}

std::vector<PublishedRow> rowsOf(const nlohmann::json& vector)
{
    std::vector<PublishedRow> rows;
    for (const auto& row : vector["rows"])
        rows.push_back(row.get<PublishedRow>());
    return rows;
}

nlohmann::json pairJson(const std::optional<std::pair<int, int>>& pair)
{
    return pair ? nlohmann::json{pair->first, pair->second} : nlohmann::json();
}

nlohmann::json choicesJson(const std::vector<PublishedChoice>& choices)
{
    auto json = nlohmann::json::array();
    for (const PublishedChoice& choice : choices)
        json.push_back({choice.column, choice.distance});
    return json;
}

nlohmann::json antennasJson(const std::vector<PublishedPoint>& antennas)
{
    auto json = nlohmann::json::array();
    for (const PublishedPoint& antenna : antennas)
        json.push_back({antenna.x, antenna.y});
    return json;
}

class PublishedVectors : public testing::TestWithParam<std::size_t> {};

TEST_P(PublishedVectors, giveTheSameStatusAndTheSameIntegers)
{
    const auto vector = test::readVector("seed_solver.json")["cases"][GetParam()];
    const auto& expected = vector["verbatim"];
    const PublishedResult result = solverFor(vector).solve(rowsOf(vector));

    EXPECT_EQ(toText(result.status), expected["status"].get<std::string>());
    if (expected.contains("counts")) {
        EXPECT_EQ(nlohmann::json(result.counts), expected["counts"]);
    } else {
        EXPECT_TRUE(result.counts.empty());
    }
    EXPECT_EQ(pairJson(result.firstPair), expected.value("sol1", nlohmann::json()));
    EXPECT_EQ(pairJson(result.secondPair), expected.value("sol2", nlohmann::json()));
    EXPECT_EQ(choicesJson(result.choices), expected.value("best", nlohmann::json::array()));
    if (expected.contains("ant")) {
        EXPECT_EQ(antennasJson(result.antennas), expected["ant"]);
    }
    ASSERT_EQ(result.centre.has_value(), expected.contains("x"));
    if (!result.centre)
        return;
    EXPECT_EQ(result.centre->x, expected["x"].get<int>());
    EXPECT_EQ(result.centre->y, expected["y"].get<int>());
    EXPECT_NEAR(*result.antennaBearing_deg, expected["angleTemp"].get<double>(), 1e-9);
    EXPECT_NEAR(*result.heading_deg, expected["angle"].get<double>(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(AllCases, PublishedVectors, testing::Range<std::size_t>(0, 18));

TEST(PublishedSeedSolver, isTestedOnEveryKindOfEnding)
{
    const auto cases = test::readVector("seed_solver.json")["cases"];
    ASSERT_EQ(cases.size(), 18U) << "the range of PublishedVectors must cover every case";
    std::set<std::string> endings;
    for (const auto& vector : cases)
        endings.insert(vector["verbatim"]["status"].get<std::string>());
    EXPECT_EQ(endings, (std::set<std::string>{"ok", "hang_pair", "hang_best", "index", "nan", "div0",
                                              "array_overflow"}));
}

TEST(PublishedSeedSolver, survivesEmptyShortAndForeignTables)
{
    const PublishedSeedSolver solver({{0, 0}, {10, 0}, {0, 10}});
    EXPECT_EQ(solver.solve({}).status, PublishedStatus::Index);
    EXPECT_EQ(solver.solve({{{1, 0}}}).status, PublishedStatus::Index);
    const std::vector<PublishedRow> foreign(8, {{100, 0}, {101, 0}, {102, 0}});
    EXPECT_EQ(solver.solve(foreign).status, PublishedStatus::Index);
    const PublishedSeedSolver large(std::vector<PublishedPoint>(121));
    const std::vector<PublishedRow> badRssi(8, {{61, 9}, {62, 9}, {63, 9}});
    EXPECT_EQ(large.solve(badRssi).status, PublishedStatus::Index);
}

TEST(PublishedSeedSolver, neverRecordsATagWhoseNumberIsTheFirstRssiOfItsRow)
{
    const PublishedSeedSolver solver(std::vector<PublishedPoint>(9));
    const PublishedResult result = solver.solve({{{4, 2}, {1, 0}, {2, 7}, {3, 1}}});
    EXPECT_EQ(result.counts.front(), 3);
}

} // namespace
} // namespace agv::estimation
