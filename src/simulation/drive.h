// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/random.h"
#include "core/robot_status.h"
#include "simulation/plant_settings.h"

namespace agv::simulation {

/// Travel of the two wheels within one step, m.
struct WheelTravel {
    double left = 0.0;
    double right = 0.0;
};

/// Motors, wheels and encoders of one AGV.
class Drive {
public:
    struct Step {
        WheelTravel ground;  ///< what moved the robot
        WheelTravel encoder; ///< what the encoders saw
    };

    Drive(const DriveModel& model, SplitMix64 random);

    /// One step of `seconds` towards `commanded`, at the wheel factor of the battery.
    Step step(WheelSpeeds commanded, double batteryFactor, double seconds);
    /// Share of the travel lost by slipping, 0..1.
    void setSlip(double share) { m_slip = share; }
    /// Something blocks the robot: the wheels stop at once.
    void halt() { m_speeds = {}; }

    WheelSpeeds speeds() const { return m_speeds; } ///< of the wheels, true

private:
    double slipped(double travel);

    DriveModel m_model;
    SplitMix64 m_random;
    double m_imbalance;
    double m_encoderScale;
    double m_slip = 0.0;
    WheelSpeeds m_speeds;
};

/// The pose after both wheels have rolled by `travel` (exact for a circular arc up to the third order).
Pose2 rolled(const Pose2& pose, WheelTravel travel, double track_m);

} // namespace agv::simulation
