// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/likelihood_bank.h"
#include "estimation/rssi_likelihood.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <fstream>
#include <map>

namespace agv::estimation {
namespace {

constexpr NoiseModel kReference{.distanceSd_m = 0.002, .offByOne = 0.3, .missed = 0.15, .outlier = 2e-3};

nlohmann::json loadReference()
{
    std::ifstream file(AGV_TEST_DATA "/vectors/loglik.json");
    return nlohmann::json::parse(file);
}

TEST(RssiLikelihood, EqualsTheReferenceForEveryOutcomeAndDistance)
{
    const RssiLikelihood likelihood(seedRssiTable(), kReference);
    const auto reference = loadReference();
    ASSERT_GT(reference.at("cases").size(), 100u);
    for (const auto& c : reference.at("cases")) {
        const int outcome = c.at(0).get<int>();
        const double distance_m = metresFromMm(c.at(1).get<double>());
        const double expected = c.at(2).get<double>();
        EXPECT_NEAR(likelihood.logProbability(outcome, distance_m), expected, 1e-9 * std::abs(expected))
            << "outcome " << outcome << " at " << distance_m << " m";
    }
}

double totalOf(const nlohmann::json& c)
{
    const int side = c.at("field") == "11x11" ? 11 : 3;
    const auto tags = tagGrid(side, side, 0.1, {}, TagUid{1});
    const RssiLikelihood likelihood(seedRssiTable(), kReference);
    const Point2 centre{metresFromMm(c.at("x").get<double>()), metresFromMm(c.at("y").get<double>())};
    double total = 0.0;
    std::size_t stop = 0;
    for (const auto& row : c.at("rows")) {
        const double a = radFromDeg(c.at("bearing").get<double>() +
                                    static_cast<double>(stop++) * c.at("step").get<double>());
        std::map<int, int> read;
        for (const auto& r : row)
            read.emplace(r.at(0).get<int>(), r.at(1).get<int>());
        std::vector<TagObservation> observations;
        for (const FloorTag& tag : tags)
            observations.push_back(
                {tag.position, read.contains(tag.number) ? read.at(tag.number) : kNotRead});
        total += logLikelihood(likelihood, {centre.x + 0.1 * std::cos(a), centre.y + 0.1 * std::sin(a)},
                               observations);
    }
    return total;
}

TEST(RssiLikelihood, EqualsTheReferenceTotalsOfWholeTurnsOverAllTags)
{
    const auto reference = loadReference();
    ASSERT_EQ(reference.at("totals").size(), 9u);
    for (const auto& c : reference.at("totals"))
        EXPECT_NEAR(totalOf(c), c.at("loglik").get<double>(), 1e-6) << c.at("scenario");
}

TEST(RssiLikelihood, OutcomesOfEveryDistanceSumToOne)
{
    for (double d = 0.0; d < 0.3; d += 0.0007) {
        double sum = 0.0;
        for (const double p : RssiLikelihood(seedRssiTable(), kReference).probabilities(d)) {
            EXPECT_GT(p, 0.0);
            sum += p;
        }
        EXPECT_NEAR(sum, 1.0, 1e-12) << d;
    }
}

TEST(RssiLikelihood, NamesWhatIsWrongWithATable)
{
    EXPECT_STREQ(problemOf(seedRssiTable()), "");
    EXPECT_STREQ(problemOf({}), "rssi_table_size");
    EXPECT_STREQ(problemOf({{0.1, 0}, {0.2, 1}}), "rssi_table_order");
    EXPECT_STREQ(problemOf({{0.1, 8}}), "rssi_table_rssi");
    EXPECT_STREQ(problemOf({{std::nan(""), 1}}), "rssi_table_edge");
}

TEST(LikelihoodBank, AgreesWithTheExactLikelihoodUpToTheFarConstant)
{
    const std::array models{kReference, NoiseModel{0.006, 0.5, 0.25, 1e-2}};
    const LikelihoodBank bank(seedRssiTable(), models, flatBeyond(seedRssiTable(), 0.006));
    for (int m = 0; m < 2; ++m) {
        const RssiLikelihood exact(seedRssiTable(), models[static_cast<std::size_t>(m)]);
        const double far = exact.logProbability(kNotRead, 5.0);
        for (int cell = 0; cell < bank.cells(); cell += 7) {
            const double d = cell / static_cast<double>(bank.cellsPerMetre());
            for (int outcome = 0; outcome < kOutcomes; ++outcome)
                EXPECT_NEAR(bank.at(m, outcome, d),
                            exact.logProbability(outcome, d) - (outcome == kNotRead ? far : 0.0), 2e-5)
                    << m << ' ' << outcome << ' ' << d;
        }
        EXPECT_NEAR(bank.at(m, kNotRead, 3.0), 0.0, 1e-4);
    }
}

} // namespace
} // namespace agv::estimation
