// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QStringList>
#include <QWidget>

#include "gui/theme.h"

#include <memory>
#include <vector>

namespace agv::gui {

/// Stacked bars over numbered categories. The sources of this folder alone know QCustomPlot (its header costs
/// seconds of compile time and needs Qt keywords, so it stays behind this wall).
class BarChart : public QWidget {
    Q_OBJECT
public:
    struct Series {
        QString name;
        std::vector<double> values; ///< one per category, >= 0
        QColor fill;
        QColor edge;
        Qt::BrushStyle pattern = Qt::SolidPattern;
    };

    explicit BarChart(QWidget* parent = nullptr);
    ~BarChart() override;

    void setTheme(const Theme& theme);
    void setAxisTitles(const QString& categories, const QString& values);
    /// Series from the bottom of the stack to its top.
    void setData(const QStringList& categories, const std::vector<Series>& series);

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace agv::gui
