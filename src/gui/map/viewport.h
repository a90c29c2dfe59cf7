// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMarginsF>
#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "core/geometry.h"

namespace agv::gui {

/// Plant frame (m, y up) <-> widget pixels (device-independent, y down). A value; knows nothing of painting.
class Viewport {
public:
    static constexpr double minScale = 5.0;     ///< px/m: 200 m fill a screen
    static constexpr double maxScale = 20000.0; ///< px/m: 20 px a millimetre

    void setSize(QSizeF size) { m_size = size; }
    QSizeF size() const { return m_size; }

    double scale() const { return m_scale; }   ///< px/m
    Point2 centre() const { return m_centre; } ///< plant point in the middle of the widget, m
    void setCentre(Point2 centre) { m_centre = centre; }
    void setScale(double pxPerMetre);

    QPointF toPixels(Point2 p) const;
    Point2 toPlant(QPointF pixel) const;
    double toPixels(double metres) const { return metres * m_scale; }

    /// Zooms by `factor`, clamped; the plant point under `pixel` stays there.
    void zoomAt(QPointF pixel, double factor);
    /// Moves the picture by `delta` pixels.
    void pan(QPointF delta);
    /// Shows the whole of `area` (m; y of its corners in the plant frame) inside the widget less `margins`
    /// (px).
    void fit(const QRectF& area, const QMarginsF& margins);
    /// The part of the plant that can be seen, m; bottom() is the largest y.
    QRectF visibleArea() const;

    friend bool operator==(const Viewport&, const Viewport&) = default;

private:
    QSizeF m_size{1.0, 1.0};
    Point2 m_centre;
    double m_scale = 100.0;
};

/// The largest of 1, 2, 5 times a power of ten that is not above `value` (> 0).
double niceStepBelow(double value);

} // namespace agv::gui
