// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/standing_pose.h"

#include "core/units.h"

#include <cmath>

namespace agv::session {

TurnEstimate standingAt(TurnEstimate estimate, int steps)
{
    const double turned = signOf(estimate.rotation) * steps * estimate.step;
    estimate.pose.heading = wrapAngle(estimate.startPose.heading + turned);
    return estimate;
}

PoseCovariance covarianceOfPose(const TurnEstimate& estimate)
{
    PoseCovariance covariance = estimate.covariance;
    const double headingSd = std::sqrt(covariance[8]);
    if (!(headingSd > 0.0) || !(estimate.lastHeadingSd > 0.0))
        return covariance;
    // Scaling row and column keeps the correlations, and so the matrix positive.
    const double scale = estimate.lastHeadingSd / headingSd;
    for (const std::size_t index : {2U, 5U, 6U, 7U})
        covariance[index] *= scale;
    covariance[8] *= scale * scale;
    return covariance;
}

} // namespace agv::session
