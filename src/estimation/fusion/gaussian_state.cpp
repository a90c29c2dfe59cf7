// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fusion/gaussian_state.h"

#include <Eigen/LU>

namespace agv::estimation {

namespace {

double dot(const SensitivityRow& row, const GaussianState::Vector& v)
{
    double sum = 0.0;
    for (const Sensitivity& s : row)
        sum += s.value * v(s.state);
    return sum;
}

} // namespace

GaussianState::GaussianState(int size) : mean(Vector::Zero(size)), p(Matrix::Zero(size, size)) {}

GaussianState::Vector GaussianState::crossCovariance(const SensitivityRow& row) const
{
    Vector sum = Vector::Zero(mean.size());
    for (const Sensitivity& s : row)
        sum += s.value * p.col(s.state);
    return sum;
}

double GaussianState::variance(const SensitivityRow& row) const
{
    double sum = 0.0;
    for (const Sensitivity& a : row)
        for (const Sensitivity& b : row)
            sum += a.value * b.value * p(a.state, b.state);
    return sum;
}

void GaussianState::update(const SensitivityRow& row, double innovation, double variance, double weight,
                           double spread)
{
    const Vector ph = crossCovariance(row);
    const double factor = (spread - weight * variance) / (variance * variance);
    mean += (weight * innovation / variance) * ph;
    for (Eigen::Index k = 0; k < ph.size(); ++k)
        p.col(k) += (factor * ph(k)) * ph;
}

Eigen::Matrix2d GaussianState::covariance(const SensitivityRow& first, const SensitivityRow& second) const
{
    const double cross = dot(first, crossCovariance(second));
    Eigen::Matrix2d result;
    result << variance(first), cross, cross, variance(second);
    return result;
}

void GaussianState::update(const SensitivityRow& first, const SensitivityRow& second,
                           const Eigen::Vector2d& innovation, const Eigen::Matrix2d& noise)
{
    const Vector a = crossCovariance(first);
    const Vector b = crossCovariance(second);
    const double cross = dot(first, b);
    Eigen::Matrix2d s;
    s << dot(first, a) + noise(0, 0), cross + noise(0, 1), cross + noise(1, 0), dot(second, b) + noise(1, 1);
    const Eigen::Matrix2d inverse = s.inverse();
    const Vector ka = a * inverse(0, 0) + b * inverse(1, 0);
    const Vector kb = a * inverse(0, 1) + b * inverse(1, 1);
    mean += ka * innovation(0) + kb * innovation(1);
    for (Eigen::Index k = 0; k < a.size(); ++k)
        p.col(k) -= ka * a(k) + kb * b(k);
}

} // namespace agv::estimation
