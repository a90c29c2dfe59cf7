// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/measurement_record.h"
#include "estimation/uwb/fix.h"

namespace agv::estimation {

struct PlanarEkfSettings {
    double height_m = 0.0;  ///< of the tag
    double walkSd_m = 0.1;  ///< sd of the movement per square root of a second: the manual's Q, m
    double startSd_m = 0.3; ///< of a coordinate at the start
};

/// The extended Kalman filter of the technical manual (3.8 to 3.17): state (x, y) that only diffuses (A = 1),
/// all ranges of a report at once, F their Jacobian. Corrected: 3.17 is (I - K F) P; the division of 3.9
/// and 3.11 by the speed of light cancels. Kept for comparison: it knows no speed and no obstruction.
class PlanarEkf {
public:
    explicit PlanarEkf(const PlanarEkfSettings& settings = {}) : m_settings(settings) {}

    /// Starts at the linear fix from these ranges; false when they do not give one.
    bool start(AnchorRanges ranges);
    void start(const Eigen::Vector2d& position, const Eigen::Matrix2d& covariance);
    bool started() const { return m_started; }
    void predict(double dt_s);
    const MeasurementRecords& update(AnchorRanges ranges);

    const Eigen::Vector2d& position() const { return m_position; }
    const Eigen::Matrix2d& covariance() const { return m_covariance; }

private:
    PlanarEkfSettings m_settings;
    Eigen::Vector2d m_position = Eigen::Vector2d::Zero();
    Eigen::Matrix2d m_covariance = Eigen::Matrix2d::Zero();
    MeasurementRecords m_records;
    bool m_started = false;
};

} // namespace agv::estimation
