// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/plant_layout.h"

#include <string>
#include <vector>

namespace agv {

/// Where an anchor stands by the ranges between the anchors, in the survey's own frame.
struct SurveyedAnchor {
    int id = 0;
    Point2 position;   ///< m; the first anchor is the origin, the second lies on +x, the third towards +y
    double sd_m = 0.0; ///< of the position, largest direction, as far as the ranges tell
    friend bool operator==(const SurveyedAnchor&, const SurveyedAnchor&) = default;
};

/// Positions of anchors found from the ranges between them.
struct AnchorSurvey {
    std::vector<SurveyedAnchor> anchors; ///< by id; empty: see trouble
    double residual_m = 0.0;             ///< root mean square of range minus distance; 0 with three anchors
    std::string trouble;                 ///< why there are none; plain English
    std::vector<std::string> notes;      ///< what to know, such as anchors that do not range; plain English
    friend bool operator==(const AnchorSurvey&, const AnchorSurvey&) = default;
};

/// How a survey lies in the plant.
struct SurveyFrame {
    Point2 origin;         ///< of the first anchor, plant frame, m
    double angle = 0.0;    ///< from the plant's +x to the line from the first to the second anchor, rad
    bool mirrored = false; ///< the third anchor lies to the right of that line
    friend bool operator==(const SurveyFrame&, const SurveyFrame&) = default;
};

/// The frame in which the survey lies closest to the anchors of the list (least squares, without a change of
/// scale). With fewer than two in common the survey's own frame.
SurveyFrame closestFrame(const AnchorSurvey& survey, const std::vector<UwbAnchor>& anchors);

/// The anchors of the list at their surveyed places; those that were not surveyed stay.
std::vector<UwbAnchor> placed(const AnchorSurvey& survey, const SurveyFrame& frame,
                              std::vector<UwbAnchor> anchors);

} // namespace agv
