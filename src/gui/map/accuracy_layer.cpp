// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/accuracy_layer.h"

#include "core/anchor_geometry.h"
#include "model/words.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace agv::gui {
namespace {

struct AccuracyTexts {
    Q_DECLARE_TR_FUNCTIONS(agv::gui::AccuracyTexts)
public:
    static QString title() { return tr("Expected UWB\naccuracy, 95 %"); }
    static QString upTo(double radius_m) { return tr("up to %1").arg(model::Words::millimetres(radius_m)); }
    static QString beyond(double radius_m) { return tr("over %1").arg(model::Words::millimetres(radius_m)); }
    static QString none() { return tr("no position"); }
};

/// Upper edges of the steps of the shading, m.
constexpr std::array accuracySteps_m{0.10, 0.15, 0.20, 0.30, 0.50};
constexpr int noPosition = static_cast<int>(accuracySteps_m.size()) + 1;
constexpr double cell_px = 6.0;

int stepOf(const std::optional<double>& radius)
{
    if (!radius)
        return noPosition;
    return static_cast<int>(std::ranges::lower_bound(accuracySteps_m, *radius) - accuracySteps_m.begin());
}

QBrush accuracyShade(int step, const Theme& theme)
{
    QColor colour = theme.alternative;
    if (step == noPosition) {
        colour.setAlpha(150);
        return {colour, Qt::BDiagPattern};
    }
    colour.setAlpha(14 + 26 * step);
    return colour;
}

} // namespace

std::optional<double> expectedUwbRadius(const PlantLayout& plant, Point2 place)
{
    const std::optional<double> dilution = horizontalDilution(plant.anchors, place, plant.uwb.tagHeight_m);
    return dilution ? std::optional(2.0 * *dilution * assumedRangeSd_m) : std::nullopt;
}

void paintAccuracy(QPainter& painter, const Viewport& viewport, const PlantLayout& plant, const Theme& theme)
{
    const QRectF floor(plant.origin.x, plant.origin.y, plant.width_m, plant.height_m);
    const QRectF area = floor & viewport.visibleArea();
    if (area.isEmpty())
        return;
    const QPointF corner = viewport.toPixels(Point2{area.left(), area.bottom()});
    const int columns = static_cast<int>(std::ceil(viewport.toPixels(area.width()) / cell_px));
    const int rows = static_cast<int>(std::ceil(viewport.toPixels(area.height()) / cell_px));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setClipRect(
        QRectF(corner, QSizeF(viewport.toPixels(area.width()), viewport.toPixels(area.height()))),
        Qt::IntersectClip);
    std::vector<int> above(static_cast<std::size_t>(columns), -1);
    QList<QLineF> edges;
    for (int row = 0; row < rows; ++row) {
        int runStart = 0;
        int runStep = -1;
        for (int column = 0; column <= columns; ++column) {
            const QPointF cell = corner + QPointF(column * cell_px, row * cell_px);
            const int step = column == columns
                                 ? -1
                                 : stepOf(expectedUwbRadius(
                                       plant, viewport.toPlant(cell + QPointF(cell_px / 2, cell_px / 2))));
            if (step != runStep) {
                if (runStep >= 0)
                    painter.fillRect(QRectF(corner.x() + runStart * cell_px, cell.y(),
                                            (column - runStart) * cell_px, cell_px),
                                     accuracyShade(runStep, theme));
                if (runStep >= 0 && step >= 0)
                    edges << QLineF(cell, cell + QPointF(0.0, cell_px));
                runStart = column;
                runStep = step;
            }
            if (column == columns)
                break;
            int& before = above[static_cast<std::size_t>(column)];
            if (before >= 0 && before != step)
                edges << QLineF(cell, cell + QPointF(cell_px, 0.0));
            before = step;
        }
    }
    painter.setPen(QPen(theme.alternative, 1.0));
    painter.drawLines(edges);
    painter.restore();
}

void paintAccuracyLegend(QPainter& painter, QPointF upperRight, const Theme& theme)
{
    const QFontMetricsF metrics(painter.font());
    const double line = metrics.height() + 2.0;
    constexpr double swatch = 22.0;
    QStringList texts;
    for (const double edge : accuracySteps_m)
        texts << AccuracyTexts::upTo(edge);
    texts << AccuracyTexts::beyond(accuracySteps_m.back()) << AccuracyTexts::none();
    const QRectF title = metrics.boundingRect(QRectF(0, 0, 400, 100), Qt::AlignLeft, AccuracyTexts::title());
    double width = title.width();
    for (const QString& text : texts)
        width = std::max(width, swatch + 6.0 + metrics.horizontalAdvance(text));
    const QSizeF size(width + 16.0, title.height() + line * static_cast<double>(texts.size()) + 16.0);
    const QRectF box(upperRight - QPointF(size.width(), 0.0), size);
    painter.save();
    painter.setPen(QPen(theme.border, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(box, 5.0, 5.0);
    painter.setPen(theme.text);
    painter.drawText(QRectF(box.topLeft() + QPointF(8.0, 5.0), title.size()), Qt::AlignLeft,
                     AccuracyTexts::title());
    for (int step = 0; step < texts.size(); ++step) {
        const QRectF row(box.left() + 8.0, box.top() + title.height() + 9.0 + line * step, width, line);
        const QRectF sample(row.left(), row.top() + 2.0, swatch, line - 4.0);
        painter.fillRect(sample, theme.mapFloor);
        painter.fillRect(sample, accuracyShade(step, theme));
        painter.setPen(QPen(theme.border, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(sample);
        painter.setPen(theme.text);
        painter.drawText(row.adjusted(swatch + 6.0, 0.0, 0.0, 0.0), Qt::AlignVCenter, texts[step]);
    }
    painter.restore();
}

} // namespace agv::gui
