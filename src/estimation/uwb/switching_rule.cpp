// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/switching_rule.h"

#include <algorithm>

namespace agv::estimation {

SwitchingRule::SwitchingRule(std::span<const Eigen::Vector3d> anchors, const SwitchingSettings& settings)
    : m_settings(settings)
{
    if (anchors.empty())
        return;
    m_least = m_most = {anchors[0].x(), anchors[0].y()};
    for (const Eigen::Vector3d& a : anchors) {
        m_least = {std::min(m_least.x, a.x()), std::min(m_least.y, a.y())};
        m_most = {std::max(m_most.x, a.x()), std::max(m_most.y, a.y())};
    }
}

bool SwitchingRule::inside(Point2 p) const
{
    const double m = m_settings.margin_m;
    return p.x >= m_least.x - m && p.x <= m_most.x + m && p.y >= m_least.y - m && p.y <= m_most.y + m;
}

SwitchingRule::Choice SwitchingRule::choose(std::optional<Point2> uwb, std::optional<Point2> floorTag)
{
    Choice choice{m_last, m_last ? SwitchingSource::Held : SwitchingSource::None};
    if (uwb && (inside(*uwb) || !floorTag)) {
        choice = {uwb, SwitchingSource::Uwb};
    } else if (uwb && floorTag) {
        const double a = 1.0 / (m_settings.uwbError_m * m_settings.uwbError_m);
        const double b = 1.0 / (m_settings.floorTagError_m * m_settings.floorTagError_m);
        choice = {(1.0 / (a + b)) * (a * *uwb + b * *floorTag), SwitchingSource::Both};
    } else if (floorTag) {
        choice = {floorTag, SwitchingSource::FloorTag};
    }
    m_last = choice.position;
    return choice;
}

} // namespace agv::estimation
