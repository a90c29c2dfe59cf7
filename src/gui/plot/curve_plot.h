// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QWidget>

#include "gui/theme.h"
#include "model/time_series.h"

#include <memory>
#include <optional>
#include <vector>

class QPainter;

namespace agv::gui {

/// Curves over an axis, with zoom to the pointer, pan, and a cursor that reads their values. Knows
/// QCustomPlot so that nobody else does. GUI thread.
class CurvePlot : public QWidget {
    Q_OBJECT
public:
    /// Told apart by colour and by dashes; the first five colours also differ for colour-blind people.
    static constexpr int styleCount = 10;

    explicit CurvePlot(QWidget* parent = nullptr);
    ~CurvePlot() override;

    void setTheme(const Theme& theme);
    /// Titles with units.
    void setAxisTitles(const QString& x, const QString& y);
    /// The curves there are, in their order; those that stay keep their data.
    void setCurves(const QStringList& names);
    /// Drawn at the next replot(). `points` rise in t.
    void setPoints(int curve, const std::vector<model::SeriesPoint>& points);
    /// Vertical lines with a word each: x, text.
    void setMarks(const std::vector<std::pair<double, QString>>& marks);
    /// Lower right instead of upper left, and not with so many curves that it would hide them: for
    /// distributions.
    void keepLegendSmall();
    void setXRange(double from, double to);
    double xFrom() const;
    double xTo() const;
    /// Fits y to the points that were set, with some room; from zero when `fromZero`.
    void fitY(bool fromZero);
    void replot();
    /// Width of the drawing in px: no more points than that can be seen.
    int plotWidth() const;
    /// What stands there when there are no points; empty: nothing.
    void setHint(const QString& hint);
    /// For pictures, of `size` px.
    void paint(QPainter& painter, QSize size) const;

signals:
    /// By the operator's wheel or drag.
    void xRangeChosen(double from, double to);
    /// The pointer is at this x; also when it leaves (nullopt).
    void cursorMoved(std::optional<double> x);

protected:
    void leaveEvent(QEvent* event) override;

private:
    void connectPlot();
    void styleCurves();

    class Private;
    std::unique_ptr<Private> d;
};

} // namespace agv::gui
