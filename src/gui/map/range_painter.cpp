// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/range_painter.h"

#include "model/words.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace agv::gui {
namespace {

struct RangeTexts {
    Q_DECLARE_TR_FUNCTIONS(agv::gui::RangeTexts)
public:
    static QString of(const UwbRangeSnapshot& range)
    {
        const QString state = range.rejected ? tr("obstructed") : tr("clear");
        if (!range.residual_m)
            return state;
        const double whole_mm = std::round(*range.residual_m * 1e3);
        const QString sign = whole_mm < 0.0   ? QStringLiteral("−")
                             : whole_mm > 0.0 ? QStringLiteral("+")
                                              : QString();
        return tr("%1, %2").arg(state, sign + model::Words::millimetres(std::abs(whole_mm) * 1e-3));
    }
};

void paintRangeNote(QPainter& painter, QPointF anchor, const QString& text, const QColor& colour,
                    const Theme& theme)
{
    const QFontMetricsF metrics(painter.font());
    const QRectF box(anchor + QPointF(9.0, -metrics.height() - 5.0),
                     QSizeF(metrics.horizontalAdvance(text) + 10.0, metrics.height() + 2.0));
    painter.setPen(QPen(colour, 1.0));
    painter.setBrush(theme.raised);
    painter.drawRoundedRect(box, 3.0, 3.0);
    painter.setPen(theme.text);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace

double radiusOnPlan(const UwbAnchor& anchor, double range_m, double z_m)
{
    const double height = anchor.z - z_m;
    return std::sqrt(std::max(0.0, range_m * range_m - height * height));
}

void paintRanges(QPainter& painter, const Viewport& viewport, const UwbTagSnapshot& tag,
                 const std::vector<UwbAnchor>& anchors, const Theme& theme)
{
    painter.save();
    for (const UwbRangeSnapshot& range : tag.ranges) {
        const auto anchor = std::ranges::find(anchors, range.anchor, &UwbAnchor::id);
        if (anchor == anchors.end() || !anchor->shown)
            continue;
        const QPointF centre = viewport.toPixels(Point2{anchor->x, anchor->y});
        const double radius = viewport.toPixels(radiusOnPlan(*anchor, range.range_m, tag.z_m));
        const QColor colour = range.rejected ? theme.warning : theme.estimate;
        painter.setPen(
            QPen(colour, range.rejected ? 1.6 : 1.1, range.rejected ? Qt::DashLine : Qt::SolidLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, radius, radius);
        paintRangeNote(painter, centre, RangeTexts::of(range), colour, theme);
    }
    painter.restore();
}

} // namespace agv::gui
