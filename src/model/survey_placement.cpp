// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/survey_placement.h"

#include "core/units.h"

#include <algorithm>
#include <numbers>

namespace agv::model {
namespace {

Point2 turned(Point2 p, double angle) { return fromVehicleFrame({{}, angle}, p); }

Point2 inPlant(const SurveyFrame& frame, Point2 p)
{
    return fromVehicleFrame({frame.origin, frame.angle}, {p.x, frame.mirrored ? -p.y : p.y});
}

/// `anchor` at (0, 0), the anchor after it in the survey (the one before it for the last) on +x.
SurveyFrame atAnchor(const AnchorSurvey& survey, int anchor)
{
    const auto origin = std::ranges::find(survey.anchors, anchor, &SurveyedAnchor::id);
    if (origin == survey.anchors.end() || survey.anchors.size() < 2)
        return {};
    const auto next = origin + 1 == survey.anchors.end() ? origin - 1 : origin + 1;
    const Point2 along = next->position - origin->position;
    const double angle = -std::atan2(along.y, along.x);
    return {.origin = -1.0 * turned(origin->position, angle), .angle = angle, .mirrored = false};
}

Point2 pivotOf(const AnchorSurvey& survey, const SurveyFrame& frame, const SurveyPlacement& placement)
{
    if (placement.originAnchor || survey.anchors.empty())
        return {};
    Point2 mean;
    for (const SurveyedAnchor& anchor : survey.anchors)
        mean = mean + 1.0 / static_cast<double>(survey.anchors.size()) * inPlant(frame, anchor.position);
    return mean;
}

} // namespace

SurveyFrame frameOf(const AnchorSurvey& survey, const std::vector<UwbAnchor>& anchors,
                    const SurveyPlacement& placement)
{
    SurveyFrame frame =
        placement.originAnchor ? atAnchor(survey, *placement.originAnchor) : closestFrame(survey, anchors);
    const Point2 pivot = pivotOf(survey, frame, placement);
    if (placement.flipped) {
        // x -> -x about the pivot is the mirror in y followed by half a turn, so the frame stays a frame.
        const Point2 off = frame.origin - pivot;
        frame = {.origin = pivot + Point2{-off.x, off.y},
                 .angle = wrapAngle(std::numbers::pi - frame.angle),
                 .mirrored = !frame.mirrored};
    }
    frame.origin = pivot + turned(frame.origin - pivot, placement.rotation);
    frame.angle = wrapAngle(frame.angle + placement.rotation);
    return frame;
}

} // namespace agv::model
