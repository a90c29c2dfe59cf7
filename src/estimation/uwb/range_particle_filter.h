// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "estimation/measurement_record.h"
#include "estimation/uwb/fix.h"
#include "estimation/uwb/obstruction.h"

#include <vector>

namespace agv::estimation {

struct RangeParticleSettings {
    int particles = 600;            ///< 16 or more
    double height_m = 0.0;          ///< of the tag
    double acceleration = 0.15;     ///< sd of the white acceleration, m/s^2
    double hidden = 0.2;            ///< share of ranges with an obstructed path
    double meanBias_m = 0.35;       ///< mean of their excess
    double startSd_m = 0.2;         ///< of the position at the start
    double startSpeedSd = 0.3;      ///< m/s
    double floorTagRadius_m = 0.09; ///< a floor tag fix is within this distance of the truth
    std::uint64_t seed = 1;
};

/// Particle filter of the thesis (3.22 to 3.34; manual, chapter 4): particles (x, y, vx, vy), importance
/// weights from ranges and floor tags, resampled when half of them no longer count, spread a little after
/// that. A range counts as normal or as normal plus exponential; a floor tag as a disc with a soft edge. No
/// allocation after construction; the same seed and input give the same track.
class RangeParticleFilter {
public:
    explicit RangeParticleFilter(const RangeParticleSettings& settings = {});

    void start(const Eigen::Vector2d& position);
    /// Starts at a robust fix from these ranges; false when they do not give one.
    bool start(AnchorRanges ranges);
    bool started() const { return m_started; }
    void predict(double dt_s);
    /// Weighs by the ranges; resamples when needed.
    const MeasurementRecords& update(AnchorRanges ranges);
    /// Weighs by a position from floor tags, m.
    MeasurementRecord updateFloorTag(const Eigen::Vector2d& position);

    Eigen::Vector2d position() const; ///< weighted mean, m
    Eigen::Vector2d velocity() const; ///< weighted mean, m/s
    Eigen::Matrix2d covariance() const;

private:
    double logLikelihood(double error, double sd_m) const;
    void normalise();
    void resampleWhenNeeded();

    RangeParticleSettings m_settings;
    SplitMix64 m_random;
    std::vector<double> m_x, m_y, m_vx, m_vy, m_weight, m_log, m_spare;
    MeasurementRecords m_records;
    bool m_started = false;
};

} // namespace agv::estimation
