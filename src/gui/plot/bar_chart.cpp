// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/plot/bar_chart.h"

#include "gui/plot/axis_style.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace agv::gui {

class BarChart::Private {
public:
    QCustomPlot* plot = nullptr;
    QSharedPointer<QCPAxisTickerText> ticker{new QCPAxisTickerText};
};

BarChart::BarChart(QWidget* parent) : QWidget(parent), d(std::make_unique<Private>())
{
    d->plot = new QCustomPlot(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(d->plot);
    d->plot->xAxis->setTicker(d->ticker);
    d->plot->xAxis->grid()->setVisible(false);
    d->plot->setNoAntialiasingOnDrag(true);
    // The legend stands above the bars, in one line.
    auto* legendLayout = new QCPLayoutGrid;
    d->plot->plotLayout()->insertRow(0);
    d->plot->plotLayout()->addElement(0, 0, legendLayout);
    legendLayout->addElement(0, 0, d->plot->legend);
    d->plot->legend->setFillOrder(QCPLegend::foColumnsFirst);
    d->plot->legend->setBorderPen(Qt::NoPen);
    d->plot->legend->setMargins(QMargins(2, 0, 2, 0));
    d->plot->legend->setIconSize(14, 10);
    legendLayout->setMargins(QMargins(0, 0, 0, 0));
    d->plot->plotLayout()->setRowSpacing(0);
    d->plot->legend->setVisible(true);
    d->plot->plotLayout()->setRowStretchFactor(0, 0.001);
}

BarChart::~BarChart() = default;

void BarChart::setTheme(const Theme& theme)
{
    d->plot->setBackground(theme.panel);
    d->plot->legend->setBrush(theme.panel);
    d->plot->legend->setTextColor(theme.mutedText);
    d->plot->legend->setFont(font());
    styleAxis(*d->plot->xAxis, theme, font());
    styleAxis(*d->plot->yAxis, theme, font());
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

void BarChart::setAxisTitles(const QString& categories, const QString& values)
{
    d->plot->xAxis->setLabel(categories);
    d->plot->yAxis->setLabel(values);
    setAccessibleName(values + QStringLiteral(" / ") + categories);
}

void BarChart::setData(const QStringList& categories, const std::vector<Series>& series)
{
    const auto count = static_cast<std::size_t>(categories.size());
    d->ticker->clear();
    for (int i = 0; i < categories.size(); ++i)
        d->ticker->addTick(i + 1, categories[i]);
    d->plot->clearPlottables();
    QCPBars* below = nullptr;
    std::vector<double> totals(count, 0.0);
    for (const Series& one : series) {
        auto* bars = new QCPBars(d->plot->xAxis, d->plot->yAxis);
        bars->setName(one.name);
        bars->setPen(QPen(one.edge, 1.2));
        bars->setBrush(QBrush(one.fill, one.pattern));
        bars->setWidth(0.62);
        for (std::size_t i = 0; i < std::min(count, one.values.size()); ++i) {
            // A bar of height zero would still show as a line.
            if (one.values[i] > 0.0)
                bars->addData(static_cast<double>(i + 1), one.values[i]);
            totals[i] += one.values[i];
        }
        if (below)
            bars->moveAbove(below);
        below = bars;
    }
    const double highest = totals.empty() ? 1.0 : *std::max_element(totals.begin(), totals.end());
    d->plot->xAxis->setRange(0.4, static_cast<double>(count) + 0.6);
    d->plot->yAxis->setRange(0.0, std::max(1.0, highest * 1.1));
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

} // namespace agv::gui
