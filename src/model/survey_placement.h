// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/anchor_survey.h"

#include <optional>
#include <vector>

namespace agv::model {

/// How the operator lays a survey into the plant.
struct SurveyPlacement {
    /// This anchor becomes the plant's origin and the next one lies on +x; empty: closest to the present
    /// list.
    std::optional<int> originAnchor;
    bool flipped = false;  ///< east and west exchanged
    double rotation = 0.0; ///< rad, counter-clockwise
    friend bool operator==(const SurveyPlacement&, const SurveyPlacement&) = default;
};

/// The frame in which the survey then lies. Flip and rotation are about the origin anchor, or about the mean
/// of the surveyed anchors.
SurveyFrame frameOf(const AnchorSurvey& survey, const std::vector<UwbAnchor>& anchors,
                    const SurveyPlacement& placement);

} // namespace agv::model
