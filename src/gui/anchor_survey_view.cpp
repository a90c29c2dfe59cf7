// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/anchor_survey_view.h"

#include "model/anchor_table_model.h"
#include "model/words.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace agv::gui {
namespace {

constexpr double anchorSize_px = 7.0;
constexpr double leastMove_m = 0.0005; ///< half of what is shown
constexpr double scaleBar_px = 90.0;   ///< longest

QPolygonF triangleAt(QPointF at)
{
    const double size = anchorSize_px;
    return {at + QPointF(0.0, -size), at + QPointF(size, 0.8 * size), at + QPointF(-size, 0.8 * size)};
}

} // namespace

AnchorSurveyView::AnchorSurveyView(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Present and proposed places of the anchors"));
}

void AnchorSurveyView::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void AnchorSurveyView::setAnchors(const std::vector<UwbAnchor>& present,
                                  const std::vector<UwbAnchor>& proposed)
{
    m_present = present;
    m_proposed = proposed;
    update();
}

Viewport AnchorSurveyView::viewport() const
{
    Point2 least{m_present.front().x, m_present.front().y};
    Point2 most = least;
    for (const std::vector<UwbAnchor>* anchors : {&m_present, &m_proposed}) {
        for (const UwbAnchor& anchor : *anchors) {
            least = {std::min(least.x, anchor.x), std::min(least.y, anchor.y)};
            most = {std::max(most.x, anchor.x), std::max(most.y, anchor.y)};
        }
    }
    constexpr double leastExtent_m = 0.1;
    Viewport view;
    view.setSize(size());
    view.fit(QRectF(least.x, least.y, std::max(most.x - least.x, leastExtent_m),
                    std::max(most.y - least.y, leastExtent_m)),
             QMarginsF(50, 30, 110, 44));
    return view;
}

void AnchorSurveyView::paintAxes(QPainter& painter, const Viewport& view) const
{
    const double length_m = niceStepBelow(scaleBar_px / view.scale());
    const QPointF left(12.0, height() - 12.0);
    const QPointF right = left + QPointF(view.toPixels(length_m), 0.0);
    painter.setPen(QPen(m_theme.mutedText, 1.2));
    painter.drawLine(left, right);
    painter.drawLine(left - QPointF(0, 4), left + QPointF(0, 4));
    painter.drawLine(right - QPointF(0, 4), right + QPointF(0, 4));
    painter.drawText(right + QPointF(8, 5), model::Words::millimetres(length_m));
    // The plant's origin, where it is in sight.
    const QPointF origin = view.toPixels(Point2{});
    if (rect().contains(origin.toPoint())) {
        painter.setPen(QPen(m_theme.strongBorder, 1.2));
        painter.drawLine(origin, origin + QPointF(24, 0));
        painter.drawLine(origin, origin - QPointF(0, 24));
        painter.setPen(m_theme.mutedText);
        painter.drawText(origin + QPointF(27, 5), QStringLiteral("x"));
        painter.drawText(origin + QPointF(-4, -28), QStringLiteral("y"));
    }
}

void AnchorSurveyView::paintPresent(QPainter& painter, const Viewport& view, const UwbAnchor& anchor) const
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.mutedText, 1.4));
    painter.drawPolygon(triangleAt(view.toPixels(Point2{anchor.x, anchor.y})));
}

void AnchorSurveyView::paintProposed(QPainter& painter, const Viewport& view, const UwbAnchor& now,
                                     const UwbAnchor& then) const
{
    const QPointF from = view.toPixels(Point2{now.x, now.y});
    if (then == now) // not surveyed
        return paintName(painter, from, now, tr("stays"));
    const QPointF to = view.toPixels(Point2{then.x, then.y});
    const double moved_m = distance({now.x, now.y}, {then.x, then.y});
    if (moved_m >= leastMove_m) {
        painter.setPen(QPen(m_theme.estimate, 1.2, Qt::DashLine));
        painter.drawLine(from, to);
    }
    painter.setPen(QPen(m_theme.estimate, 1.4));
    painter.setBrush(m_theme.estimate);
    painter.drawPolygon(triangleAt(to));
    paintName(painter, to, then, model::Words::millimetres(moved_m));
}

void AnchorSurveyView::paintName(QPainter& painter, QPointF at, const UwbAnchor& anchor,
                                 const QString& second) const
{
    const double ascent = painter.fontMetrics().ascent();
    painter.setPen(m_theme.text);
    painter.drawText(at + QPointF(anchorSize_px + 5.0, ascent * 0.2), model::anchorName(anchor));
    painter.setPen(m_theme.mutedText);
    painter.drawText(at + QPointF(anchorSize_px + 5.0, ascent * 1.4), second);
}

void AnchorSurveyView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.border, 1.0));
    painter.setBrush(m_theme.mapFloor);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6.0, 6.0);
    if (m_present.empty())
        return;
    const Viewport view = viewport();
    paintAxes(painter, view);
    for (const UwbAnchor& anchor : m_present)
        paintPresent(painter, view, anchor);
    if (m_proposed.size() != m_present.size()) {
        for (const UwbAnchor& anchor : m_present)
            paintName(painter, view.toPixels(Point2{anchor.x, anchor.y}), anchor, {});
        return;
    }
    for (std::size_t i = 0; i < m_present.size(); ++i)
        paintProposed(painter, view, m_present[i], m_proposed[i]);
}

} // namespace agv::gui
