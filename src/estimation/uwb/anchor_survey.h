// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/anchor_survey.h"
#include "core/plant_layout.h"
#include "core/uwb_snapshot.h"

#include <vector>

namespace agv::estimation {

struct AnchorSurveySettings {
    int rangesNeeded = 5; ///< a pair with fewer is not used
    /// What repeating does not average out of the range of a pair: delays, reflections; sd in m, > 0.
    double pairSd_m = 0.03;
    /// A residual beyond, m, is worth a note.
    double noteBeyond_m = 0.15;
    /// Root mean square of the residuals beyond which there are no places, m.
    double hopelessBeyond_m = 0.5;
    /// Anchors nearer to one line than this share of its length leave open how far beside it they stand.
    double flattest = 0.05;
};

/// Where the anchors stand, from the ranges between them. Heights are those of the list and taken for true:
/// ranges are slant distances, and taking them for distances on the floor makes the plant too large, by 4 %
/// with anchors 4 m apart and 1.2 m of difference in height.
///
/// Start: the triangle with the largest area, then one anchor after the other from the placed ones that it
/// ranges with; where two places are possible both are followed. Then maximum likelihood over all positions
/// together (Gauss-Newton with Levenberg's damping) with sd^2 = sd of the median^2 + pairSd_m^2 for each
/// pair. Of two arrangements that fit alike the one nearer to the list is taken, and this is noted.
///
/// Anchors that range with fewer than two placed ones are not placed, nor are networks without a triangle,
/// rigid or not. The sds are those of the network as a whole, so that no anchor is better than another only
/// because the frame begins at it; they grow when the residuals are larger than the sds of the pairs say.
AnchorSurvey surveyAnchors(const std::vector<AnchorPairSnapshot>& pairs, const std::vector<UwbAnchor>& listed,
                           const AnchorSurveySettings& settings = {});

} // namespace agv::estimation
