// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/battery.h"

#include <algorithm>
#include <cmath>

namespace agv::simulation {

double wheelFactor(const DriveModel& drive, double charge)
{
    return std::lerp(drive.emptyBatteryFactor, drive.fullBatteryFactor, charge);
}

double nominalCharge(const DriveModel& drive)
{
    return (1.0 - drive.emptyBatteryFactor) / (drive.fullBatteryFactor - drive.emptyBatteryFactor);
}

void Battery::step(double seconds, WheelSpeeds wheels, bool onHomeBase)
{
    m_onHomeBase = onHomeBase;
    const double load =
        m_model.idleCurrent_A + m_model.driveCurrent_A_s_m * (std::abs(wheels.left) + std::abs(wheels.right));
    m_current_A = -load;
    if (onHomeBase)
        m_current_A = m_charge < m_model.trickleAbove ? m_model.chargeCurrent_A : 0.05;
    setCharge(m_charge + m_current_A * seconds / 3600.0 / m_model.capacity_Ah);
}

void Battery::setCharge(double charge) { m_charge = std::clamp(charge, 0.0, 1.0); }

BatteryStatus Battery::status() const
{
    BatteryStatus status;
    if (m_onHomeBase)
        status.charging =
            m_charge < m_model.trickleAbove ? ChargingState::FullCharging : ChargingState::Trickle;
    status.voltage_V = std::lerp(m_model.emptyVoltage_V, m_model.fullVoltage_V, m_charge) +
                       m_current_A * m_model.resistance_Ohm;
    status.current_A = m_current_A;
    status.temperature_degC = m_onHomeBase ? 29 : 25;
    status.charge_Ah = m_charge * m_model.capacity_Ah;
    status.capacity_Ah = m_model.capacity_Ah;
    status.homeBase = m_onHomeBase;
    return status;
}

} // namespace agv::simulation
