// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/anchor_range.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace agv::estimation {

/// Ranges of one tag measured together, by the index of the anchor; 0: not measured.
struct RangeSample {
    std::array<float, kMaxAnchors> range_m{};
    Eigen::Vector2d position = Eigen::Vector2d::Zero(); ///< of the tag, roughly: the fit begins there, m
};

/// What may be wrong with the ranges of an anchor.
enum class AnchorFault : std::uint8_t {
    None,   ///< of no anchor
    Offset, ///< too long or too short by the same everywhere: hidden, or wrongly calibrated
    Moved,  ///< measured from another place at the same height
};

/// Least-squares fit of samples with one fault of one anchor.
struct AnchorFaultFit {
    Eigen::Vector2d displacement = Eigen::Vector2d::Zero(); ///< true place minus place in the list, m
    Eigen::Matrix2d covariance =
        Eigen::Matrix2d::Zero(); ///< of displacement, for the misfit that is left, m^2
    double offset_m = 0.0;       ///< measured minus true range of the anchor
    /// Median over the samples of the squared residuals per degree of freedom, in units of the variance of a
    /// range. Without a fault, and with all that is known calibrated, about 1.
    double misfit = 0.0;
    int samples = 0;   ///< that counted
    double cost = 0.0; ///< minus the log likelihood, but for a constant
};

/// Fits samples of a tag of known height. Unknown are the place of the tag at every sample, the offset of
/// every anchor (a prior of 0.1 m: antenna delays) and the fault of the anchor `suspect`: its displacement,
/// or an offset without bound. Gauss-Newton; the places are eliminated sample by sample, as in the adjustment
/// of geodetic networks (Baarda). Samples that do not fit weigh less (Cauchy), so that an obstruction of
/// another anchor does not spoil the result. Samples with fewer than four ranges, or from anchors on one
/// line, do not count. At most mostSamples samples.
class AnchorFaultModel {
public:
    static constexpr std::size_t mostSamples = 128;
    static constexpr double rangeSd_m = 0.05;

    /// By index, at most kMaxAnchors; `height_m` of the tag.
    AnchorFaultModel(std::vector<Eigen::Vector3d> anchors, double height_m);

    int anchorCount() const { return static_cast<int>(m_anchors.size()); }
    AnchorFaultFit fit(std::span<const RangeSample> samples, AnchorFault fault, int suspect) const;
    /// Measured range of an anchor minus the distance from the place that the others give, m; nothing when
    /// they are fewer than three or on one line.
    std::optional<double> residualByOthers(const RangeSample& sample, int anchor) const;
    /// By how much a range grows when the tag moves by one: the direction from the anchor to the tag, its
    /// part along the floor.
    Eigen::Vector2d direction(const RangeSample& sample, int anchor) const;

private:
    std::vector<Eigen::Vector3d> m_anchors;
    double m_height_m;
};

} // namespace agv::estimation
