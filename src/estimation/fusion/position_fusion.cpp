// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/fusion/position_fusion.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

PositionFusion::PositionFusion(const PositionFusionSettings& settings)
    : m_settings(settings),
      m_model(settings.model),
      m_state(4 + RangeModel::biasStates(settings.model, settings.anchors))
{}

void PositionFusion::start(const Eigen::Vector2d& position)
{
    m_state = GaussianState(m_state.size());
    m_model = RangeModel(m_settings.model);
    m_state.mean.head<2>() = position;
    const double place = m_settings.startSd_m * m_settings.startSd_m;
    const double speed = m_settings.startSpeedSd * m_settings.startSpeedSd;
    m_state.p.diagonal().head<4>() << place, place, speed, speed;
    m_model.startBiases(m_state, firstBias());
    m_started = true;
}

void PositionFusion::predict(double dt_s)
{
    if (!m_started || !(dt_s > 0.0) || !std::isfinite(dt_s))
        return;
    m_state.mean.head<2>() += dt_s * m_state.mean.segment<2>(2);
    GaussianState::Matrix& p = m_state.p;
    p.topRows<2>() += dt_s * p.middleRows<2>(2);
    p.leftCols<2>() += dt_s * p.middleCols<2>(2);
    m_model.predict(m_state, firstBias(), dt_s);
    const double q = m_settings.acceleration * m_settings.acceleration;
    const double half = 0.5 * dt_s * dt_s;
    for (const int i : {0, 1}) {
        p(i, i) += q * half * half;
        p(i + 2, i + 2) += q * dt_s * dt_s;
        p(i, i + 2) += q * half * dt_s;
        p(i + 2, i) += q * half * dt_s;
    }
}

Placement PositionFusion::placement(double age_s) const
{
    Placement tag;
    tag.position = position() - age_s * velocity();
    tag.x.add({0, 1.0});
    tag.y.add({1, 1.0});
    if (age_s != 0.0) {
        tag.x.add({2, -age_s});
        tag.y.add({3, -age_s});
    }
    return tag;
}

const MeasurementRecords& PositionFusion::update(AnchorRanges ranges, double age_s)
{
    m_records.clear();
    if (m_started)
        for (const AnchorRange& range : ranges)
            m_records.add(m_model.range(m_state, placement(age_s), range, firstBias()));
    return m_records;
}

MeasurementRecord PositionFusion::updateFloorTag(const Eigen::Vector2d& position, double sd_m)
{
    MeasurementRecord record;
    record.kind = MeasurementKind::FloorTag;
    return m_started ? m_model.floorTag(m_state, placement(0.0), position, sd_m) : record;
}

double PositionFusion::bias_m(int anchor) const
{
    return firstBias() >= 0 && anchor >= 0 && anchor < m_settings.anchors ? m_state.mean(firstBias() + anchor)
                                                                          : 0.0;
}

} // namespace agv::estimation
