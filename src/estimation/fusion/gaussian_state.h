// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/fixed_list.h"
#include "estimation/uwb/anchor_range.h"

#include <Eigen/Core>

namespace agv::estimation {

/// One non-zero element of a row of a measurement matrix.
struct Sensitivity {
    int state = 0;
    double value = 0.0;
};
using SensitivityRow = FixedList<Sensitivity, 8>;

/// Mean and covariance of up to kMaxStates quantities, with the updates of a Kalman filter. Measurements
/// touch few states, so their rows are sparse. Nothing allocates.
class GaussianState {
public:
    static constexpr int kMaxStates = 40;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxStates, 1>;
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxStates, kMaxStates>;

    /// All zero, size 1..kMaxStates.
    explicit GaussianState(int size);

    int size() const { return static_cast<int>(mean.size()); }
    /// H P H'.
    double variance(const SensitivityRow& row) const;
    /// Scalar measurement: the gain for an innovation variance of `variance`, applied with `weight` (1:
    /// fully). The covariance falls by weight S K K' and grows by spread K K'.
    void update(const SensitivityRow& row, double innovation, double variance, double weight = 1.0,
                double spread = 0.0);
    /// Two measurements at once; `noise` is the covariance of their errors.
    void update(const SensitivityRow& first, const SensitivityRow& second, const Eigen::Vector2d& innovation,
                const Eigen::Matrix2d& noise);
    /// H P H' of two rows.
    Eigen::Matrix2d covariance(const SensitivityRow& first, const SensitivityRow& second) const;

    Vector mean;
    Matrix p; ///< covariance

private:
    Vector crossCovariance(const SensitivityRow& row) const;
};

} // namespace agv::estimation
