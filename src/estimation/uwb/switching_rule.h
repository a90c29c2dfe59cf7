// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <Eigen/Core>
#include <optional>
#include <span>

namespace agv::estimation {

struct SwitchingSettings {
    /// Mean errors of table 6.2, which weigh the two fixes where both are there, m.
    double uwbError_m = 0.2285;
    double floorTagError_m = 0.06;
    double margin_m = 0.1; ///< a UWB fix this far outside the anchors' rectangle still counts as inside
};

enum class SwitchingSource : std::uint8_t { None, Uwb, FloorTag, Both, Held };

/// The composite system of the thesis (chapters 3.2 and 6.2.4): inside the array UWB alone; outside it both,
/// each weighted by the inverse square of its mean error; then whichever is there; with neither the last
/// position is held. Kept for comparison with the fusion filters.
class SwitchingRule {
public:
    /// The array is the rectangle around the anchors.
    explicit SwitchingRule(std::span<const Eigen::Vector3d> anchors, const SwitchingSettings& settings = {});

    struct Choice {
        std::optional<Point2> position; ///< nothing before the first fix
        SwitchingSource source = SwitchingSource::None;
    };
    Choice choose(std::optional<Point2> uwb, std::optional<Point2> floorTag);

private:
    bool inside(Point2 p) const;

    SwitchingSettings m_settings;
    Point2 m_least, m_most;
    std::optional<Point2> m_last;
};

} // namespace agv::estimation
