// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/viewport.h"

#include <algorithm>
#include <cmath>

namespace agv::gui {

void Viewport::setScale(double pxPerMetre) { m_scale = std::clamp(pxPerMetre, minScale, maxScale); }

QPointF Viewport::toPixels(Point2 p) const
{
    return {0.5 * m_size.width() + (p.x - m_centre.x) * m_scale,
            0.5 * m_size.height() - (p.y - m_centre.y) * m_scale};
}

Point2 Viewport::toPlant(QPointF pixel) const
{
    return {m_centre.x + (pixel.x() - 0.5 * m_size.width()) / m_scale,
            m_centre.y - (pixel.y() - 0.5 * m_size.height()) / m_scale};
}

void Viewport::zoomAt(QPointF pixel, double factor)
{
    const Point2 fixed = toPlant(pixel);
    setScale(m_scale * factor);
    const Point2 moved = toPlant(pixel);
    m_centre = m_centre + (fixed - moved);
}

void Viewport::pan(QPointF delta)
{
    m_centre = {m_centre.x - delta.x() / m_scale, m_centre.y + delta.y() / m_scale};
}

void Viewport::fit(const QRectF& area, const QMarginsF& margins)
{
    const double width = std::max(1.0, m_size.width() - margins.left() - margins.right());
    const double height = std::max(1.0, m_size.height() - margins.top() - margins.bottom());
    setScale(std::min(width / std::max(area.width(), 1e-3), height / std::max(area.height(), 1e-3)));
    m_centre = {area.center().x(), area.center().y()};
    pan({0.5 * (margins.left() - margins.right()), 0.5 * (margins.top() - margins.bottom())});
}

QRectF Viewport::visibleArea() const
{
    const Point2 topLeft = toPlant({0.0, 0.0});
    const Point2 bottomRight = toPlant({m_size.width(), m_size.height()});
    return {QPointF(topLeft.x, bottomRight.y), QPointF(bottomRight.x, topLeft.y)};
}

double niceStepBelow(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
    const double mantissa = value / power * (1.0 + 1e-9);
    return power * (mantissa >= 5.0 ? 5.0 : mantissa >= 2.0 ? 2.0 : 1.0);
}

} // namespace agv::gui
