// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/anchor_survey.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace agv {
namespace {

using PointPair = std::pair<Point2, Point2>; ///< surveyed, listed

std::vector<PointPair> commonAnchors(const AnchorSurvey& survey, const std::vector<UwbAnchor>& anchors)
{
    std::vector<PointPair> pairs;
    for (const SurveyedAnchor& surveyed : survey.anchors) {
        const auto listed = std::ranges::find(anchors, surveyed.id, &UwbAnchor::id);
        if (listed != anchors.end())
            pairs.emplace_back(surveyed.position, Point2{listed->x, listed->y});
    }
    return pairs;
}

Point2 toPlant(const SurveyFrame& frame, Point2 p)
{
    return fromVehicleFrame({frame.origin, frame.angle}, {p.x, frame.mirrored ? -p.y : p.y});
}

/// The best rotation and translation in closed form: the angle of the summed products of centred points.
SurveyFrame closest(const std::vector<PointPair>& pairs, bool mirrored)
{
    const double share = 1.0 / static_cast<double>(pairs.size());
    Point2 surveyedMean;
    Point2 listedMean;
    const auto mirror = [mirrored](Point2 p) { return Point2{p.x, mirrored ? -p.y : p.y}; };
    for (const auto& [surveyed, listed] : pairs) {
        surveyedMean = surveyedMean + share * mirror(surveyed);
        listedMean = listedMean + share * listed;
    }
    double along = 0.0;
    double across = 0.0;
    for (const auto& [surveyed, listed] : pairs) {
        const Point2 p = mirror(surveyed) - surveyedMean;
        const Point2 q = listed - listedMean;
        along += p.x * q.x + p.y * q.y;
        across += p.x * q.y - p.y * q.x;
    }
    SurveyFrame frame{.origin = {}, .angle = std::atan2(across, along), .mirrored = mirrored};
    frame.origin = listedMean - fromVehicleFrame({{}, frame.angle}, surveyedMean);
    return frame;
}

double squaredMisfit(const SurveyFrame& frame, const std::vector<PointPair>& pairs)
{
    double sum = 0.0;
    for (const auto& [surveyed, listed] : pairs) {
        const double off = distance(toPlant(frame, surveyed), listed);
        sum += off * off;
    }
    return sum;
}

} // namespace

SurveyFrame closestFrame(const AnchorSurvey& survey, const std::vector<UwbAnchor>& anchors)
{
    const std::vector<PointPair> pairs = commonAnchors(survey, anchors);
    if (pairs.size() < 2)
        return {};
    const SurveyFrame straight = closest(pairs, false);
    const SurveyFrame mirrored = closest(pairs, true);
    return squaredMisfit(mirrored, pairs) < squaredMisfit(straight, pairs) ? mirrored : straight;
}

std::vector<UwbAnchor> placed(const AnchorSurvey& survey, const SurveyFrame& frame,
                              std::vector<UwbAnchor> anchors)
{
    for (UwbAnchor& anchor : anchors) {
        const auto surveyed = std::ranges::find(survey.anchors, anchor.id, &SurveyedAnchor::id);
        if (surveyed == survey.anchors.end())
            continue;
        const Point2 place = toPlant(frame, surveyed->position);
        anchor.x = place.x;
        anchor.y = place.y;
    }
    return anchors;
}

} // namespace agv
