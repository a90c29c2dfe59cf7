// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/locator.h"

#include <algorithm>
#include <array>

namespace agv::estimation {

namespace {

using enum MethodInput;

constexpr std::array kMethods{
    MethodInfo{"ekf-los", "EKF with a line-of-sight state per anchor",
               "hidden Markov mode per anchor, weighted gain (the program's own)", Ranges, false},
    MethodInfo{"static", "position of a standing tag from all its reports",
               "mixture likelihood of seen and hidden ranges, posterior mean (own)", Ranges, false},
    MethodInfo{"robust", "robust fix of one report", "hypotheses of hidden anchors, averaged (own)", Ranges,
               false},
    MethodInfo{"gauss-newton", "nonlinear least squares, known height", "Gauss-Newton, Levenberg 1944",
               Ranges, false},
    MethodInfo{"gauss-newton-3d", "nonlinear least squares in space, two mirrored starts",
               "Gauss-Newton, Levenberg 1944", Ranges, true},
    MethodInfo{"huber", "nonlinear least squares with Huber weights", "Huber 1964", Ranges, false},
    MethodInfo{"linear-2d", "linear TOA in the plane", "thesis 5.5, 5.6", Ranges, false},
    MethodInfo{"linear-3d", "linear TOA in space", "thesis 5.19 to 5.23", Ranges, true},
    MethodInfo{"two-step", "modified two-step weighted 3-D TOA, origin moved",
               "thesis 5.19 to 5.39, misprints corrected", Ranges, true},
    MethodInfo{"two-step-published", "modified two-step weighted 3-D TOA, origin as it is",
               "thesis 5.19 to 5.39, misprints corrected", Ranges, true},
    MethodInfo{"tdoa", "differences of arrival times", "thesis 5.11 to 5.15", Ranges, false},
    MethodInfo{"biased-kalman", "Kalman filter per range with a known mean error, then a fix",
               "thesis 3.3 to 3.11", Ranges, false},
    MethodInfo{"ekf-manual", "EKF of a diffusing position", "manual 3.8 to 3.17", Ranges, false},
    MethodInfo{"ekf", "EKF with constant velocity", "manual 3.8 to 3.17, with velocity", Ranges, false},
    MethodInfo{"ekf-robust", "EKF that weighs ranges by their innovation", "one-sided Huber weights (own)",
               Ranges, false},
    MethodInfo{"particle", "particle filter on ranges", "thesis 3.22 to 3.34, manual chapter 4", Ranges,
               false},
    MethodInfo{"fusion", "fusion of ranges, floor tags and wheel odometry",
               "EKF with odometry scales, heading offset and range errors as states (own; default of fuse)",
               Fusion, false},
    MethodInfo{"fusion-position", "fusion of ranges and floor tags without odometry",
               "EKF with range errors as states (own)", Fusion, false},
    MethodInfo{"fusion-particle", "particle filter on ranges and floor tags",
               "thesis 3.22 to 3.34, manual chapter 4", Fusion, false},
    MethodInfo{"switching", "UWB, floor tags or both by rule", "thesis chapters 3.2 and 6.2.4", Fusion,
               false},
    MethodInfo{"rfid-average", "mean of the floor tags read", "thesis 4.1", Fusion, false},
    MethodInfo{"aoa", "angles of arrival", "thesis 5.2, 5.3", Special, false},
    MethodInfo{"fingerprint", "nearest neighbour in a table of fingerprints", "thesis 4.3.3, 4.4", Special,
               false},
    MethodInfo{"body", "pose of a vehicle with several tags",
               "EKF of all tags' ranges, wheels roll along the heading (own)", Special, false},
    MethodInfo{"floor", "particle filter for driving on the tagged floor",
               "P(tag, RSSI | place) and wheel speeds (own)", Special, false},
};

} // namespace

std::span<const MethodInfo> allMethods() { return kMethods; }

const MethodInfo* findMethod(std::string_view name)
{
    const auto* method = std::ranges::find(kMethods, name, &MethodInfo::name);
    return method == kMethods.end() ? nullptr : method;
}

} // namespace agv::estimation
