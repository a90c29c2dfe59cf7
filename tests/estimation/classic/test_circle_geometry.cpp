// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/circle_geometry.h"

#include "estimation/classic/turn_vectors.h"

#include <gtest/gtest.h>

namespace agv::estimation {
namespace {

double toleranceFor(double value) { return 1e-9 * std::max(1.0, std::abs(value)); }

Point2 pointFrom(const nlohmann::json& xy) { return {xy[0].get<double>(), xy[1].get<double>()}; }

TEST(Trilateration, equalsEveryReferenceVectorAndReportsTheDegenerateOnes)
{
    int degenerate = 0;
    for (const auto& vector : test::readVector("trilateration.json")) {
        std::array<Circle, 3> circles;
        for (std::size_t k = 0; k < 3; ++k)
            circles[k] = {pointFrom(vector["P_cm"][k]), vector["r_cm"][k].get<double>()};
        const auto point = trilaterate(circles);
        if (vector["xy_cm"][0].is_null()) {
            ++degenerate;
            EXPECT_FALSE(point.has_value()) << vector;
            continue;
        }
        ASSERT_TRUE(point.has_value()) << vector;
        const Point2 expected = pointFrom(vector["xy_cm"]);
        EXPECT_NEAR(point->x, expected.x, toleranceFor(expected.x));
        EXPECT_NEAR(point->y, expected.y, toleranceFor(expected.y));
    }
    EXPECT_EQ(degenerate, 3);
}

TEST(Trilateration, saysWhichKindOfDegenerateGeometryItMet)
{
    const Circle a{{0.0, 0.0}, 1.0};
    const Circle b{{1.0, 0.0}, 1.0};
    const Circle c{{2.0, 0.0}, 1.0};
    EXPECT_EQ(trilaterate({a, a, b}).error(), CircleGeometryError::CoincidentCentres);
    EXPECT_EQ(trilaterate({a, b, c}).error(), CircleGeometryError::CollinearCentres);
    EXPECT_EQ(trilaterate({a, b, b}).error(), CircleGeometryError::CollinearCentres);
    EXPECT_EQ(trilaterate({a, b, a}).error(), CircleGeometryError::CollinearCentres);
}

TEST(Trilateration, doesNotDependOnTheOriginOrTheUnit)
{
    const Point2 truth{0.31, 0.27};
    const std::array<Point2, 3> tags{Point2{0.3, 0.3}, Point2{0.4, 0.3}, Point2{0.3, 0.2}};
    for (const double scale : {1e-3, 1.0, 1e3}) {
        std::array<Circle, 3> circles;
        for (std::size_t k = 0; k < 3; ++k)
            circles[k] = {scale * (tags[k] + Point2{40.0, -70.0}), scale * distance(tags[k], truth)};
        const auto point = trilaterate(circles);
        ASSERT_TRUE(point.has_value());
        EXPECT_NEAR(point->x / scale - 40.0, truth.x, 1e-9);
        EXPECT_NEAR(point->y / scale + 70.0, truth.y, 1e-9);
    }
}

TEST(CentreIntersection, equalsEveryReferenceVectorAndReportsParallelLines)
{
    int parallel = 0;
    for (const auto& vector : test::readVector("centre_intersection.json")) {
        const auto& a = vector["A"];
        const auto centre =
            intersectLines(pointFrom(a[0]), pointFrom(a[1]), pointFrom(a[2]), pointFrom(a[3]));
        if (vector["exact"].is_null()) {
            ++parallel;
            ASSERT_FALSE(centre.has_value());
            EXPECT_EQ(centre.error(), CircleGeometryError::ParallelLines);
            continue;
        }
        ASSERT_TRUE(centre.has_value()) << vector;
        const Point2 expected = pointFrom(vector["exact"]);
        EXPECT_NEAR(centre->x, expected.x, toleranceFor(expected.x));
        EXPECT_NEAR(centre->y, expected.y, toleranceFor(expected.y));
    }
    EXPECT_EQ(parallel, 1);
}

TEST(CentreIntersection, ofAPointAndALineIsAnError)
{
    const Point2 p{1.0, 1.0};
    EXPECT_FALSE(intersectLines(p, p, {0.0, 0.0}, {2.0, 0.0}).has_value());
}

TEST(Flatness, isZeroForPointsOnALineAndHalfForARightAngle)
{
    EXPECT_DOUBLE_EQ(flatness({0, 0}, {1, 0}, {2, 0}), 0.0);
    EXPECT_DOUBLE_EQ(flatness({1, 1}, {1, 1}, {1, 1}), 0.0);
    EXPECT_NEAR(flatness({0, 0}, {1, 0}, {0, 1}), 0.5, 1e-12);
    EXPECT_NEAR(flatness({0, 0}, {1, 0}, {2, 1}), 0.2, 1e-12);
}

} // namespace
} // namespace agv::estimation
