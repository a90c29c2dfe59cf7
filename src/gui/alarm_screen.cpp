// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/alarm_screen.h"

#include "gui/alarm_panel.h"
#include "gui/cell_delegates.h"
#include "gui/glyphs.h"
#include "gui/main_window.h"
#include "ui_main_window.h"

#include <QDateTime>
#include <QToolButton>

namespace agv::gui {

AlarmScreen::AlarmScreen(Ui::MainWindow& ui, MainWindow* window)
    : QObject(window),
      m_ui(ui),
      m_window(window),
      m_button(new QToolButton)
{
    m_button->setObjectName(QStringLiteral("alarmButton"));
    m_button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_button->setFocusPolicy(Qt::StrongFocus);
    m_button->setAutoRaise(true);
    connect(m_button, &QToolButton::clicked, this, &AlarmScreen::showPanel);
    connect(m_ui.showAlarmsAction, &QAction::triggered, this, &AlarmScreen::showPanel);
    connect(m_ui.acknowledgeAction, &QAction::triggered, m_ui.alarms, &AlarmPanel::acknowledge);
    connect(m_ui.alarms, &AlarmPanel::acknowledgeRequested, window, &MainWindow::acknowledgeAlarmsRequested);
    connect(m_ui.alarms, &AlarmPanel::shelveRequested, window, &MainWindow::shelveAlarmsRequested);
    connect(m_ui.alarms, &AlarmPanel::unshelveRequested, window, &MainWindow::unshelveAlarmsRequested);
    updateButton();
}

void AlarmScreen::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_ui.alarms->setTheme(theme);
    updateButton();
}

void AlarmScreen::showSnapshot(const PlantSnapshot& snapshot)
{
    m_ui.alarms->showSnapshot(snapshot);
    updateButton();
    for (const EventEntry& line : m_log.linesFor(snapshot.alarms, QDateTime::currentMSecsSinceEpoch()))
        m_window->addEvent(line);
}

void AlarmScreen::retranslate() { updateButton(); }

void AlarmScreen::showPanel()
{
    m_ui.alarmsDock->show();
    m_ui.alarmsDock->raise();
    if (auto* table = m_ui.alarms->findChild<QWidget*>(QStringLiteral("alarmTable")))
        table->setFocus(Qt::ShortcutFocusReason);
}

void AlarmScreen::updateButton()
{
    const model::AlarmTableModel& alarms = m_ui.alarms->alarms();
    const int active = alarms.activeCount();
    const int fresh = alarms.newCount();
    const QString text = active == 0 && fresh == 0 ? tr("No alarms")
                         : fresh == 0              ? tr("Alarms: %1").arg(active)
                                                   : tr("Alarms: %1, %2 new").arg(active).arg(fresh);
    // The first row is the weightiest.
    const bool quiet = active == 0 && fresh == 0;
    const AlarmPriority priority =
        alarms.alarms().empty() ? AlarmPriority::Low : alarms.alarms().front().priority;
    const QColor colour = quiet ? m_theme.mutedText : colourOf(priority, m_theme);
    const QString state =
        QStringLiteral("%1/%2/%3").arg(text).arg(static_cast<int>(priority)).arg(m_theme.dark);
    if (m_button->property("shown").toString() == state)
        return;
    m_button->setProperty("shown", state);
    m_button->setText(text);
    m_button->setIcon(glyphIcon(quiet ? Glyph::Check : glyphOf(priority), colour, colour));
    m_button->setAccessibleName(text);
    m_button->setToolTip(tr("Show the list of alarms"));
}

} // namespace agv::gui
