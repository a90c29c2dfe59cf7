// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cstdint>
#include <string>

namespace agv {

/// How far the pose of an AGV can be trusted.
enum class PoseHealth : std::uint8_t {
    None,      ///< no initialisation turn yet
    Tracked,   ///< measured where it stands, or a short way before
    Predicted, ///< by the commanded wheel speeds only, for some way
    Doubted    ///< what is measured contradicts it, or nobody knows how the AGV moved; turn again
};

/// The pose of an AGV as it is followed after the initialisation turn.
struct TrackedPose {
    PoseHealth health = PoseHealth::None;
    Pose2 pose; ///< without a meaning when there is None
    PoseCovariance covariance{};
    std::string note; ///< why it is Predicted or Doubted, and what to do; plain English
    friend bool operator==(const TrackedPose&, const TrackedPose&) = default;
};

} // namespace agv
