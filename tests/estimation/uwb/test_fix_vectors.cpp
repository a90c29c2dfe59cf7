// SPDX-License-Identifier: GPL-3.0-or-later
// Fixes against the reference results: 1e-9 relative, Gauss-Newton 1e-6 m.
#include "estimation/uwb/linear_toa.h"
#include "estimation/uwb/range_fix.h"
#include "estimation/uwb/two_step_toa.h"
#include "estimation/uwb/uwb_vectors.h"

#include <gtest/gtest.h>

namespace agv::estimation {
namespace {

/// Relative 1e-9; lengths near zero to a nanometre.
void expectSame(double value, double expected, const std::string& what)
{
    EXPECT_NEAR(value, expected, 1e-9 * std::max(1.0, std::abs(expected))) << what;
}

template<typename Vector>
void expectSame(const Vector& value, const nlohmann::json& expected, const std::string& what)
{
    for (Eigen::Index i = 0; i < value.size(); ++i)
        expectSame(value(i), expected.at(static_cast<std::size_t>(i)).get<double>(),
                   what + "." + std::to_string(i));
}

struct Case {
    nlohmann::json json;
    std::vector<AnchorRange> ranges;
    std::string name;
};

std::vector<Case> casesOf(const std::string& file)
{
    std::vector<Case> cases;
    for (const auto& c : loadVector(file)) {
        const double sd = c.value("sigma_assumed", 0.05);
        cases.push_back({c, rangesFrom(anchorsOf(c), c.at("ranges").get<std::vector<double>>(), sd),
                         c.at("geom").get<std::string>() + " " + c.at("p").dump() + " noise " +
                             std::to_string(c.value("noise", -1.0))});
    }
    return cases;
}

TEST(LinearToa, EqualsTheReferenceInSpace)
{
    int checked = 0;
    for (const Case& c : casesOf("uwb_two_step.json")) {
        if (!c.json.contains("linear_ls_za"))
            continue;
        const LinearToa3d linear = linearToa3d(c.ranges);
        expectSame(linear.unknowns, c.json.at("linear_ls_za"), c.name);
        ++checked;
    }
    EXPECT_EQ(checked, 36);
}

TEST(TwoStepToa, EqualsTheReferenceAsPublishedAndWithAMovedOrigin)
{
    int checked = 0;
    for (const Case& c : casesOf("uwb_two_step.json")) {
        const TwoStepToa published = twoStepToa(c.ranges, {.originShift_m = 0.0});
        const std::string status = c.json.at("status");
        if (status == "singular_G") {
            EXPECT_EQ(published.fix.status, FixStatus::CoplanarAnchors) << c.name;
            continue;
        }
        if (c.json.contains("wls_first"))
            expectSame(published.first, c.json.at("wls_first"), c.name + " first");
        expectSame(published.second, c.json.at("wls_second"), c.name + " second");
        if (status == "singular_Psi2" || c.json.value("noise", 1.0) == 0.0) {
            // A coordinate of rounding size decides between this status and a finite answer.
            EXPECT_TRUE(published.fix.status == FixStatus::SingularWeights ||
                        published.fix.position.allFinite());
        } else {
            EXPECT_EQ(published.negativeSquare, status == "negative_square") << c.name;
            expectSame(published.fix.position, c.json.at("two_step"), c.name + " two step");
            if (c.json.contains("two_step_squares"))
                expectSame(published.squares, c.json.at("two_step_squares"), c.name + " squares");
            ++checked;
        }
        if (c.json.contains("two_step_origin_shift10")) {
            const TwoStepToa shifted = twoStepToa(c.ranges);
            EXPECT_TRUE(shifted.fix.ok()) << c.name;
            // Squares of ten metres twice: the reference itself is good to about 1e-8 here.
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(
                    shifted.fix.position(i),
                    c.json.at("two_step_origin_shift10").at(static_cast<std::size_t>(i)).get<double>(), 1e-7)
                    << c.name;
        }
    }
    EXPECT_EQ(checked, 22);
}

TEST(RangeFix, ReachesTheReferenceFromTheSameStartInSpace)
{
    int checked = 0;
    int better = 0;
    for (const Case& c : casesOf("uwb_two_step.json")) {
        if (!c.json.contains("gauss_newton_3d"))
            continue;
        const Eigen::Vector3d linear = linearToa3d(c.ranges).fix.position;
        const Eigen::Vector3d start(std::clamp(linear.x(), -1.0, 5.0), std::clamp(linear.y(), -1.0, 3.0),
                                    std::clamp(linear.z(), 0.0, 1.95));
        const UwbFix fix = fixFromRanges(c.ranges, {.start = start});
        ASSERT_TRUE(fix.ok()) << c.name;
        ++checked;
        // One reference iteration ended before the minimum: its cost is higher than ours by 5e-4.
        if (0.5 * fix.chiSquared < c.json.at("gn3d_cost").get<double>() - 1e-7) {
            ++better;
            continue;
        }
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(fix.position(static_cast<Eigen::Index>(i)),
                        c.json.at("gauss_newton_3d").at(i).get<double>(), 1e-6)
                << c.name << " axis " << i;
    }
    EXPECT_EQ(checked, 36);
    EXPECT_LE(better, 1);
}

TEST(RangeFix, FindsAMinimumNoWorseThanTheReferenceOnItsOwn)
{
    for (const Case& c : casesOf("uwb_two_step.json")) {
        if (!c.json.contains("gn3d_cost"))
            continue;
        const UwbFix fix = fixFromRanges(c.ranges, {.side = TagSide::Either});
        EXPECT_TRUE(fix.ok()) << c.name << ' ' << toText(fix.status);
        EXPECT_LE(0.5 * fix.chiSquared, c.json.at("gn3d_cost").get<double>() + 1e-9) << c.name;
    }
}

TEST(RangeFix, EqualsTheReferenceWithAPriorOfTheHeight)
{
    int checked = 0;
    for (const Case& c : casesOf("uwb_two_step.json")) {
        const bool coplanar = c.json.contains("gauss_newton_zprior");
        if (!coplanar && !c.json.contains("gauss_newton_zprior_2cm"))
            continue;
        const auto& expected = c.json.at(coplanar ? "gauss_newton_zprior" : "gauss_newton_zprior_2cm");
        const UwbFix fix = fixFromRanges(c.ranges, {.height = TagHeight{pointOf(c.json.at("p")).z(), 0.02}});
        ASSERT_TRUE(fix.ok()) << c.name;
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(fix.position(i), expected.at(static_cast<std::size_t>(i)).get<double>(), 1e-6)
                << c.name;
        ++checked;
    }
    EXPECT_EQ(checked, 37);
}

TEST(RangeBound, EqualsTheReferenceCramerRaoBounds)
{
    const auto cases = loadVector("uwb_crlb.json");
    EXPECT_EQ(cases.size(), 36U);
    for (const auto& c : cases) {
        const Eigen::Vector3d p = pointOf(c.at("p"));
        const auto anchors = anchorsOf(c);
        const auto ranges = rangesFrom(anchors, exactRanges(anchors, p), c.at("sigma").get<double>());
        const std::string name = c.at("geom").get<std::string>() + c.at("p").dump();
        const auto sdOf = [&](std::optional<TagHeight> height) -> Eigen::Vector3d {
            return rangeBound(ranges, p, height).value().diagonal().cwiseSqrt();
        };
        expectSame(sdOf({}), c.at("crlb_xyz"), name);
        expectSame(Eigen::Vector2d(sdOf(TagHeight{p.z(), 0.0}).head<2>()), c.at("crlb_xy_z_known"), name);
        expectSame(sdOf(TagHeight{p.z(), 0.02}), c.at("crlb_xyz_zprior_2cm"), name);
    }
}

} // namespace
} // namespace agv::estimation
