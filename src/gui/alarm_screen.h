// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/snapshot.h"
#include "gui/alarm_log.h"
#include "gui/theme.h"

class QToolButton;

namespace Ui {
class MainWindow;
}

namespace agv::gui {

class MainWindow;

/// The window's alarms: the panel, and the button that is always in sight and tells how many there are.
/// GUI thread.
class AlarmScreen : public QObject {
    Q_OBJECT
public:
    AlarmScreen(Ui::MainWindow& ui, MainWindow* window);

    /// Shows the number of alarms and, when it is pressed, the panel; for the bar with *Stop all*.
    QToolButton* button() { return m_button; }
    void setTheme(const Theme& theme);
    void showSnapshot(const PlantSnapshot& snapshot);
    void retranslate();

private:
    void showPanel();
    void updateButton();

    Ui::MainWindow& m_ui;
    MainWindow* m_window;
    QToolButton* m_button;
    AlarmLog m_log;
    Theme m_theme = Theme::light();
};

} // namespace agv::gui
