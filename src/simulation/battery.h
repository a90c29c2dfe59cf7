// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/robot_status.h"
#include "simulation/plant_settings.h"

namespace agv::simulation {

/// Wheel speed relative to the commanded one at a charge of 0..1.
double wheelFactor(const DriveModel& drive, double charge);

/// The charge at which the wheels turn exactly as commanded.
double nominalCharge(const DriveModel& drive);

/// The pack of one AGV: charge, and what the base reports of it.
class Battery {
public:
    Battery(const BatteryModel& model, double charge) : m_model(model), m_charge(charge) {}

    /// `wheels` are the true speeds; on the home base the pack charges.
    void step(double seconds, WheelSpeeds wheels, bool onHomeBase);
    void setCharge(double charge); ///< 0..1; clamped

    double charge() const { return m_charge; } ///< 0..1
    BatteryStatus status() const;

private:
    BatteryModel m_model;
    double m_charge;
    double m_current_A = 0.0; ///< negative while discharging
    bool m_onHomeBase = false;
};

} // namespace agv::simulation
