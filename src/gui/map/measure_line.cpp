// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/measure_line.h"

#include "model/words.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace agv::gui {

using model::Words;

namespace {

struct MeasureTexts {
    Q_DECLARE_TR_FUNCTIONS(agv::gui::MeasureTexts)
public:
    static QString parts(Point2 delta)
    {
        return tr("%1 along x, %2 along y").arg(Words::millimetres(delta.x), Words::millimetres(delta.y));
    }
};

} // namespace

QString MeasureLine::summary() const
{
    const Point2 delta = to - from;
    return QStringLiteral("%1, %2").arg(Words::millimetres(distance(from, to)),
                                        Words::degrees(std::atan2(delta.y, delta.x), 1));
}

QString MeasureLine::parts() const { return MeasureTexts::parts(to - from); }

void paintMeasureLine(QPainter& painter, const Viewport& viewport, const MeasureLine& line,
                      const Theme& theme)
{
    const QPointF from = viewport.toPixels(line.from);
    const QPointF to = viewport.toPixels(line.to);
    painter.save();
    painter.setPen(QPen(theme.raised, 4.0));
    painter.drawLine(from, to);
    painter.setPen(QPen(theme.accent, 1.8));
    painter.drawLine(from, to);
    painter.setBrush(theme.raised);
    for (const QPointF end : {from, to})
        painter.drawEllipse(end, 3.5, 3.5);
    const QString text = line.summary() + QLatin1Char('\n') + line.parts();
    const QRectF bounds =
        painter.boundingRect(QRectF(0, 0, 400, 80), Qt::AlignLeft, text).adjusted(-7.0, -4.0, 7.0, 4.0);
    // Beside the end of the line, inside the picture.
    QPointF corner = to + QPointF(12.0, 10.0);
    corner.setX(std::clamp(corner.x(), 0.0, std::max(0.0, viewport.size().width() - bounds.width() - 2.0)));
    corner.setY(
        std::clamp(corner.y(), 0.0, std::max(0.0, viewport.size().height() - bounds.height() - 30.0)));
    const QRectF box(corner, bounds.size());
    painter.setPen(QPen(theme.border, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.setPen(theme.text);
    painter.drawText(box, Qt::AlignCenter, text);
    painter.restore();
}

} // namespace agv::gui
