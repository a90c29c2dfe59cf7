// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/fusion/gaussian_state.h"
#include "estimation/measurement_record.h"
#include "estimation/uwb/obstruction.h"

#include <array>

namespace agv::estimation {

/// How a range enters a fusion filter.
enum class RangeWeighing : std::uint8_t {
    Gate,       ///< outside the gate its variance grows with the square of the innovation
    LineOfSight ///< a hidden line-of-sight state per anchor (see RangeEkf)
};

struct RangeModelSettings {
    RangeWeighing weighing = RangeWeighing::LineOfSight;
    double height_m = 0.0;   ///< of the tag
    double gate = 3.0;       ///< sds
    double sdPerMetre = 0.0; ///< growth of a range's sd beyond sdFrom_m
    double sdFrom_m = 2.0;
    double biasSd_m = 0.05;       ///< of an anchor's slowly changing error, 0: no such states
    double biasTime_s = 60.0;     ///< its correlation time (Ornstein-Uhlenbeck)
    double commonBiasSd_m = 0.10; ///< of an error all anchors share (the tag's antenna delay), 0: no state
    double commonBiasTime_s = 3600.0;
    double floorTagSd_m = 0.045; ///< of a coordinate of a position from floor tags
    ObstructionModel obstruction;
};

/// Where the tag (or RFID antenna) is for a given state, and how that depends on the state.
struct Placement {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    SensitivityRow x; ///< derivatives of its x coordinate
    SensitivityRow y;
};

/// The measurement models shared by the fusion filters: ranges with a bias state per anchor, positions from
/// floor tags. The filter says where the tag is; `firstBias` is the index of the first bias state, -1 without
/// them.
class RangeModel {
public:
    explicit RangeModel(const RangeModelSettings& settings);

    void predict(GaussianState& state, int firstBias, double dt_s);
    /// How many states the errors of so many anchors take.
    static int biasStates(const RangeModelSettings& settings, int anchors);
    void startBiases(GaussianState& state, int firstBias) const;
    MeasurementRecord range(GaussianState& state, const Placement& tag, const AnchorRange& range,
                            int firstBias);
    /// A floor-tag fix; `sd_m` 0: of the settings.
    MeasurementRecord floorTag(GaussianState& state, const Placement& antenna,
                               const Eigen::Vector2d& position, double sd_m = 0.0) const;
    double probabilitySeen(int anchor) const
    {
        return m_seen.at(static_cast<std::size_t>(anchor)).probabilitySeen();
    }
    const RangeModelSettings& settings() const { return m_settings; }

private:
    bool hasCommon() const { return m_settings.biasSd_m > 0.0 && m_settings.commonBiasSd_m > 0.0; }

    RangeModelSettings m_settings;
    std::array<Obstruction, kMaxAnchors> m_seen;
};

} // namespace agv::estimation
