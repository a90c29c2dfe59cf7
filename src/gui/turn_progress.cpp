// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/turn_progress.h"

#include <QPainter>

#include <algorithm>

namespace agv::gui {

bool isRunning(TurnPhase phase)
{
    return phase == TurnPhase::Settling || phase == TurnPhase::Reading || phase == TurnPhase::Turning ||
           phase == TurnPhase::Solving;
}

TurnProgress::TurnProgress(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void TurnProgress::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void TurnProgress::setTurn(const TurnSnapshot& turn, int expectedStops)
{
    m_phase = turn.phase;
    m_stop = turn.stop;
    m_stops = std::max(1, turn.stopCount > 0 ? turn.stopCount : expectedStops);
    m_progress = std::clamp(turn.progress, 0.0, 1.0);
    update();
}

QSize TurnProgress::sizeHint() const { return {260, fontMetrics().height() + 18}; }
QSize TurnProgress::minimumSizeHint() const { return {120, sizeHint().height()}; }

void TurnProgress::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool finished = m_phase == TurnPhase::Finished || m_phase == TurnPhase::Solving;
    const bool broken = m_phase == TurnPhase::Aborted || m_phase == TurnPhase::Failed;
    const double gap = 4.0;
    const double cellWidth = (width() - gap * (m_stops - 1)) / m_stops;
    const double cellHeight = height() - 9.0;
    QFont font = painter.font();
    font.setPixelSize(std::max(9, static_cast<int>(std::min(cellHeight * 0.58, cellWidth * 0.6))));
    painter.setFont(font);
    for (int i = 0; i < m_stops; ++i) {
        const QRectF cell(i * (cellWidth + gap), 0.5, cellWidth, cellHeight - 1.0);
        const bool done = finished || i + 1 < m_stop;
        const bool current = isRunning(m_phase) && !finished && i + 1 == m_stop;
        painter.setPen(QPen(current ? m_theme.accent : m_theme.border, current ? 2.0 : 1.0));
        painter.setBrush(done && m_phase != TurnPhase::Idle ? m_theme.selection : m_theme.raised);
        painter.drawRoundedRect(cell.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        painter.setPen(done || current ? m_theme.text : m_theme.mutedText);
        painter.drawText(cell, Qt::AlignCenter, QString::number(i + 1));
    }
    const QRectF track(0.0, height() - 4.0, width(), 4.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.border);
    painter.drawRoundedRect(track, 2, 2);
    QRectF done = track;
    done.setWidth(track.width() * (finished ? 1.0 : m_progress));
    painter.setBrush(broken ? m_theme.mutedText : m_theme.accent);
    if (m_phase != TurnPhase::Idle)
        painter.drawRoundedRect(done, 2, 2);
}

} // namespace agv::gui
