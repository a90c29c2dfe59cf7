// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/measurement_record.h"
#include "estimation/uwb/fix.h"
#include "estimation/uwb/obstruction.h"

#include <array>

namespace agv::estimation {

enum class RangeEkfMode : std::uint8_t {
    Plain,      ///< every range counts fully
    Robust,     ///< ranges outside the gate count less, too long ones sooner than too short ones
    LineOfSight ///< a hidden line-of-sight state per anchor weighs the ranges: the default
};

struct RangeEkfSettings {
    RangeEkfMode mode = RangeEkfMode::LineOfSight;
    double height_m = 0.0;      ///< of the tag
    double acceleration = 0.15; ///< sd of the white acceleration, m/s^2
    double gate = 1.5;          ///< Robust: sds of a too long range; twice as many of a too short one
    double startSd_m = 0.3;     ///< of the position at an automatic start
    double startSpeedSd = 0.3;  ///< m/s
    ObstructionModel obstruction;
};

/// Track of a moving tag of known height from its ranges: state (x, y, vx, vy), white acceleration, ranges
/// one after the other in the given order, each linearised at the state that the ones before left.
///
/// LineOfSight: p = P(seen | innovation); the gain is p K, the covariance falls by p S K K' and grows by
/// p (1 - p) min(nu^2, 9 S) K K' for not knowing which it was.
class RangeEkf {
public:
    using State = Eigen::Vector4d;
    using Covariance = Eigen::Matrix4d;

    explicit RangeEkf(const RangeEkfSettings& settings = {});

    void start(const State& state, const Covariance& covariance);
    /// Starts at a fix from these ranges; false when they do not give one.
    bool start(AnchorRanges ranges);
    void stop() { m_started = false; }
    bool started() const { return m_started; }

    /// dt in s; not positive or not finite: nothing happens.
    void predict(double dt_s);
    /// Uses the ranges of one report. A range that is not finite is recorded as rejected.
    const MeasurementRecords& update(AnchorRanges ranges);

    const State& state() const { return m_state; }
    const Covariance& covariance() const { return m_covariance; }
    const MeasurementRecords& records() const { return m_records; }
    /// Probability that an anchor (by its index) is seen without obstruction.
    double probabilitySeen(int anchor) const
    {
        return m_seen.at(static_cast<std::size_t>(anchor)).probabilitySeen();
    }
    /// Position dt seconds ahead (behind when negative): compensates the age of a report, m.
    Eigen::Vector2d positionAfter(double dt_s) const { return m_state.head<2>() + dt_s * m_state.tail<2>(); }

private:
    MeasurementRecord use(const AnchorRange& range);

    RangeEkfSettings m_settings;
    State m_state = State::Zero();
    Covariance m_covariance = Covariance::Zero();
    std::array<Obstruction, kMaxAnchors> m_seen;
    MeasurementRecords m_records;
    bool m_started = false;
};

} // namespace agv::estimation
