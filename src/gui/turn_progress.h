// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/snapshot.h"
#include "gui/theme.h"

namespace agv::gui {

/// The stops of a turn in a row: done ones filled, the current one outlined, the others empty; below them a
/// bar that fills with the turn.
class TurnProgress : public QWidget {
    Q_OBJECT
public:
    explicit TurnProgress(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setTurn(const TurnSnapshot& turn, int expectedStops);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Theme m_theme = Theme::light();
    TurnPhase m_phase = TurnPhase::Idle;
    int m_stop = 0;
    int m_stops = 9;
    double m_progress = 0.0;
};

/// True while a turn moves or computes: from the press of Initialization to its verdict.
bool isRunning(TurnPhase phase);

} // namespace agv::gui
