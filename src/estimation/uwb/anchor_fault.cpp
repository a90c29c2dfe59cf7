// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/anchor_fault.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <utility>

namespace agv::estimation {

namespace {

constexpr int kMostFaultUnknowns = kMaxAnchors + 2;
constexpr int kFaultIterations = 6;
constexpr double kFaultWeight = 1.0 / (AnchorFaultModel::rangeSd_m * AnchorFaultModel::rangeSd_m);
constexpr double kAntennaDelaySd_m = 0.1;
constexpr double kUnboundOffsetSd_m = 1.0;
constexpr double kDisplacementSd_m = 3.0;
/// Misfit per degree of freedom at which a sample has half its weight.
constexpr double kCauchyScale = 4.0;
constexpr double kLeastFaultDistance_m = 0.05;
/// Below this share of the greatest eigenvalue the anchors count as on one line.
constexpr double kLeastSpread = 0.02;

using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostFaultUnknowns, 1>;
using Normal =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostFaultUnknowns, kMostFaultUnknowns>;

/// Inverse of a symmetric positive matrix; false when it is nearly singular.
bool invertSpread(const Eigen::Matrix2d& a, Eigen::Matrix2d& inverse)
{
    const double trace = a.trace();
    if (!(a.determinant() > kLeastSpread * trace * trace / 4.0))
        return false;
    inverse = a.inverse();
    return true;
}

/// The rows of one sample, linearised: e = H dp + J du, dp of the place of the tag, du of the other unknowns.
struct FaultRows {
    int size = 0;
    std::array<int, kMaxAnchors> anchor{};
    Eigen::Matrix<double, Eigen::Dynamic, 2, 0, kMaxAnchors, 2> h;
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxAnchors, 1> e;
    Eigen::Matrix2d inverse; ///< of H' H

    /// Of the projection that takes out what another place of the tag explains.
    double projection(int row, int column) const
    {
        return (row == column ? 1.0 : 0.0) - h.row(row) * inverse * h.row(column).transpose();
    }
    auto reduced() const { return (e - h * (inverse * (h.transpose() * e))).eval(); }
    double freedom() const { return size - 2; }
    double chiSquared() const { return reduced().squaredNorm() * kFaultWeight; }
    double weight() const { return kFaultWeight / (1.0 + chiSquared() / freedom() / kCauchyScale); }
};

/// The adjustment. Unknowns: the offsets by anchor, then the displacement of the suspect if it is moved.
class FaultAdjustment {
public:
    FaultAdjustment(const std::vector<Eigen::Vector3d>& anchors, double height_m, AnchorFault fault,
                    int suspect)
        : m_anchors(anchors),
          m_height_m(height_m),
          m_count(static_cast<int>(anchors.size())),
          m_suspect(suspect),
          m_fault(fault),
          m_unknowns(Unknowns::Zero(m_count + (fault == AnchorFault::Moved ? 2 : 0)))
    {}

    void run(std::span<const RangeSample> samples)
    {
        m_samples = samples;
        for (std::size_t s = 0; s < samples.size(); ++s)
            m_places[s] = samples[s].position;
        for (int i = 0; i < kFaultIterations; ++i)
            step();
    }
    AnchorFaultFit result();

    /// False when the ranges do not determine the place of the tag. `leftOut`: an anchor; -1: none.
    bool linearise(const RangeSample& sample, const Eigen::Vector2d& at, FaultRows& rows,
                   int leftOut = -1) const;

private:
    double priorWeight(Eigen::Index unknown) const;
    void step();
    void add(const FaultRows& rows);
    void addDisplacement(const FaultRows& rows, int row, double weight, double reduced);
    void movePlaces(const Unknowns& change);
    Eigen::Vector2d displacement() const
    {
        return m_fault == AnchorFault::Moved ? Eigen::Vector2d(m_unknowns.tail<2>())
                                             : Eigen::Vector2d::Zero();
    }

    const std::vector<Eigen::Vector3d>& m_anchors;
    double m_height_m;
    int m_count;
    int m_suspect;
    AnchorFault m_fault;
    Unknowns m_unknowns;
    std::span<const RangeSample> m_samples;
    std::array<Eigen::Vector2d, AnchorFaultModel::mostSamples> m_places;
    Normal m_normal;
    Unknowns m_right;
};

bool FaultAdjustment::linearise(const RangeSample& sample, const Eigen::Vector2d& at, FaultRows& rows,
                                int leftOut) const
{
    rows.size = 0;
    for (int i = 0; i < m_count; ++i)
        if (sample.range_m[static_cast<std::size_t>(i)] > 0.0F && i != leftOut)
            rows.anchor[static_cast<std::size_t>(rows.size++)] = i;
    if (rows.size < 3)
        return false;
    rows.h.resize(rows.size, 2);
    rows.e.resize(rows.size);
    for (int row = 0; row < rows.size; ++row) {
        const int i = rows.anchor[static_cast<std::size_t>(row)];
        const Eigen::Vector3d& anchor = m_anchors[static_cast<std::size_t>(i)];
        Eigen::Vector2d away = at - anchor.head<2>();
        if (i == m_suspect)
            away -= displacement();
        const double d =
            std::max(std::hypot(away.x(), away.y(), m_height_m - anchor.z()), kLeastFaultDistance_m);
        rows.h.row(row) = away.transpose() / d;
        rows.e(row) = static_cast<double>(sample.range_m[static_cast<std::size_t>(i)]) - m_unknowns(i) - d;
    }
    return invertSpread(rows.h.transpose() * rows.h, rows.inverse);
}

double FaultAdjustment::priorWeight(Eigen::Index unknown) const
{
    double sd_m = unknown < m_count ? kAntennaDelaySd_m : kDisplacementSd_m;
    if (m_fault == AnchorFault::Offset && unknown == m_suspect)
        sd_m = kUnboundOffsetSd_m;
    return 1.0 / (sd_m * sd_m);
}

void FaultAdjustment::step()
{
    const Eigen::Index size = m_unknowns.size();
    m_normal = Normal::Zero(size, size);
    m_right = Unknowns::Zero(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        m_normal(i, i) = priorWeight(i);
        m_right(i) = -priorWeight(i) * m_unknowns(i);
    }
    FaultRows rows;
    for (std::size_t s = 0; s < m_samples.size(); ++s)
        if (linearise(m_samples[s], m_places[s], rows) && rows.size >= 4)
            add(rows);
    const Unknowns change = m_normal.ldlt().solve(m_right);
    movePlaces(change);
    m_unknowns += change;
}

/// J is 1 in the column of the row's anchor and -h' in the columns of the displacement of the suspect.
void FaultAdjustment::add(const FaultRows& rows)
{
    const auto reduced = rows.reduced();
    const double weight = rows.weight();
    for (int row = 0; row < rows.size; ++row) {
        const int i = rows.anchor[static_cast<std::size_t>(row)];
        m_right(i) += weight * reduced(row);
        for (int column = 0; column < rows.size; ++column)
            m_normal(i, rows.anchor[static_cast<std::size_t>(column)]) +=
                weight * rows.projection(row, column);
        if (m_fault == AnchorFault::Moved && i == m_suspect)
            addDisplacement(rows, row, weight, reduced(row));
    }
}

void FaultAdjustment::addDisplacement(const FaultRows& rows, int row, double weight, double reduced)
{
    const Eigen::Vector2d h = rows.h.row(row);
    m_right.tail<2>() -= weight * reduced * h;
    m_normal.bottomRightCorner<2, 2>() += weight * rows.projection(row, row) * h * h.transpose();
    for (int column = 0; column < rows.size; ++column) {
        const int j = rows.anchor[static_cast<std::size_t>(column)];
        const Eigen::Vector2d mixed = -weight * rows.projection(row, column) * h;
        m_normal.block<2, 1>(m_count, j) += mixed;
        m_normal.block<1, 2>(j, m_count) += mixed.transpose();
    }
}

/// The places that belong to the changed unknowns.
void FaultAdjustment::movePlaces(const Unknowns& change)
{
    FaultRows rows;
    for (std::size_t s = 0; s < m_samples.size(); ++s) {
        if (!linearise(m_samples[s], m_places[s], rows))
            continue;
        for (int row = 0; row < rows.size; ++row) {
            const int i = rows.anchor[static_cast<std::size_t>(row)];
            rows.e(row) -= change(i);
            if (m_fault == AnchorFault::Moved && i == m_suspect)
                rows.e(row) += rows.h.row(row).dot(change.tail<2>());
        }
        m_places[s] += rows.inverse * (rows.h.transpose() * rows.e);
    }
}

AnchorFaultFit FaultAdjustment::result()
{
    AnchorFaultFit fit;
    std::array<double, AnchorFaultModel::mostSamples> misfits{};
    std::size_t count = 0;
    FaultRows rows;
    for (std::size_t s = 0; s < m_samples.size(); ++s) {
        if (!linearise(m_samples[s], m_places[s], rows) || rows.size < 4)
            continue;
        const double chiSquared = rows.chiSquared();
        misfits[count++] = chiSquared / rows.freedom();
        fit.cost +=
            0.5 * kCauchyScale * rows.freedom() * std::log1p(chiSquared / rows.freedom() / kCauchyScale);
    }
    for (Eigen::Index i = 0; i < m_unknowns.size(); ++i)
        fit.cost += 0.5 * priorWeight(i) * m_unknowns(i) * m_unknowns(i);
    if (count > 0) {
        const auto middle = misfits.begin() + static_cast<std::ptrdiff_t>(count / 2);
        std::nth_element(misfits.begin(), middle, misfits.begin() + static_cast<std::ptrdiff_t>(count));
        fit.misfit = *middle;
    }
    fit.samples = static_cast<int>(count);
    if (m_fault == AnchorFault::Offset)
        fit.offset_m = m_unknowns(m_suspect);
    if (m_fault == AnchorFault::Moved) {
        fit.displacement = displacement();
        const Normal inverse = m_normal.inverse();
        fit.covariance = std::max(1.0, fit.misfit) * inverse.bottomRightCorner<2, 2>();
    }
    return fit;
}

} // namespace

AnchorFaultModel::AnchorFaultModel(std::vector<Eigen::Vector3d> anchors, double height_m)
    : m_anchors(std::move(anchors)),
      m_height_m(height_m)
{
    if (m_anchors.size() > kMaxAnchors)
        m_anchors.resize(kMaxAnchors);
}

AnchorFaultFit AnchorFaultModel::fit(std::span<const RangeSample> samples, AnchorFault fault,
                                     int suspect) const
{
    FaultAdjustment adjustment(m_anchors, m_height_m, fault, suspect);
    adjustment.run(samples.first(std::min(samples.size(), mostSamples)));
    return adjustment.result();
}

std::optional<double> AnchorFaultModel::residualByOthers(const RangeSample& sample, int anchor) const
{
    const FaultAdjustment adjustment(m_anchors, m_height_m, AnchorFault::None, -1);
    const auto index = static_cast<std::size_t>(anchor);
    Eigen::Vector2d at = sample.position;
    FaultRows rows;
    for (int i = 0; i < kFaultIterations; ++i) {
        if (!adjustment.linearise(sample, at, rows, anchor))
            return std::nullopt;
        at += rows.inverse * (rows.h.transpose() * rows.e);
    }
    if (!(sample.range_m[index] > 0.0F))
        return std::nullopt;
    const Eigen::Vector3d& place = m_anchors[index];
    return static_cast<double>(sample.range_m[index]) -
           std::hypot(at.x() - place.x(), at.y() - place.y(), m_height_m - place.z());
}

Eigen::Vector2d AnchorFaultModel::direction(const RangeSample& sample, int anchor) const
{
    const Eigen::Vector3d& place = m_anchors[static_cast<std::size_t>(anchor)];
    const Eigen::Vector2d away = sample.position - place.head<2>();
    return away / std::max(std::hypot(away.x(), away.y(), m_height_m - place.z()), kLeastFaultDistance_m);
}

} // namespace agv::estimation
