// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/plot/stop_fit_plot.h"

#include "gui/plot/bar_chart.h"

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QStackedLayout>

namespace agv::gui {

StopFitPlot::StopFitPlot(QWidget* parent)
    : QWidget(parent),
      m_stack(new QStackedLayout(this)),
      m_hint(new QLabel(this)),
      m_chart(new BarChart(this))
{
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_hint->setMargin(16);
    m_hint->setProperty("role", QStringLiteral("muted"));
    m_stack->addWidget(m_hint);
    m_stack->addWidget(m_chart);
    setMinimumHeight(170);
    retranslate();
}

void StopFitPlot::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_chart->setTheme(theme);
    showEstimate();
}

void StopFitPlot::setEstimate(const std::shared_ptr<const TurnEstimate>& estimate)
{
    if (estimate == m_estimate)
        return;
    m_estimate = estimate;
    showEstimate();
}

bool StopFitPlot::showsData() const { return m_stack->currentWidget() == m_chart; }

void StopFitPlot::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void StopFitPlot::retranslate()
{
    m_hint->setText(tr("No stops to compare yet. Press Calibrate: after the third stop this shows which "
                       "tags each stop saw, missed or should not have seen."));
    m_chart->setAxisTitles(tr("Stop"), tr("Floor tags"));
    showEstimate();
}

void StopFitPlot::showEstimate()
{
    if (!m_estimate || m_estimate->stops.empty()) {
        m_stack->setCurrentWidget(m_hint);
        return;
    }
    QStringList categories;
    BarChart::Series seen{tr("seen"), {}, m_theme.agvBody, m_theme.strongBorder, Qt::SolidPattern};
    BarChart::Series missed{tr("missed"), {}, m_theme.warning, m_theme.warning, Qt::BDiagPattern};
    BarChart::Series wrong{tr("out of place"), {}, m_theme.error, m_theme.error, Qt::SolidPattern};
    for (std::size_t i = 0; i < m_estimate->stops.size(); ++i) {
        const StopReport& stop = m_estimate->stops[i];
        categories << QLocale().toString(static_cast<int>(i + 1));
        seen.values.push_back(static_cast<double>(stop.seen.size()));
        missed.values.push_back(static_cast<double>(stop.missed.size()));
        wrong.values.push_back(static_cast<double>(stop.unknown.size() + stop.misplaced.size()));
    }
    m_chart->setData(categories, {seen, missed, wrong});
    m_stack->setCurrentWidget(m_chart);
}

} // namespace agv::gui
