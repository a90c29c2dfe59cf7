// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/turn.h"
#include "gui/theme.h"

#include <memory>

class QLabel;
class QStackedLayout;

namespace agv::gui {

class BarChart;

/// Which stop is bad: per stop, the tags seen, those the result expected there and did not see, and those
/// that do not belong there. Without data it says where the data comes from.
class StopFitPlot : public QWidget {
    Q_OBJECT
public:
    explicit StopFitPlot(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setEstimate(const std::shared_ptr<const TurnEstimate>& estimate);
    bool showsData() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void showEstimate();

    Theme m_theme = Theme::light();
    std::shared_ptr<const TurnEstimate> m_estimate;
    QStackedLayout* m_stack;
    QLabel* m_hint;
    BarChart* m_chart;
};

} // namespace agv::gui
