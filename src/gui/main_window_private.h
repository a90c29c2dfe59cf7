// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QToolButton>

#include "gui/alarm_screen.h"
#include "gui/main_window.h"
#include "gui/shift_log.h"
#include "gui/stop_key_filter.h"
#include "gui/theme.h"
#include "gui/uwb_screens.h"
#include "ui_main_window.h"

namespace agv::gui {

/// Inside of MainWindow: builds the frame, wires panels to each other and to the window's signals.
class MainWindow::Private {
    Q_DECLARE_TR_FUNCTIONS(agv::gui::MainWindow)
public:
    explicit Private(MainWindow* window) : q(window) {}

    void build(const PlantLayout& described);
    void connectActions();
    void connectShift();
    void connectJog();
    void connectSimulationMenu();
    void retranslate();

    enum class Appearance { System, Light, Dark };
    void setAppearance(Appearance appearance);
    void applyTheme();
    void onPaletteChange();

    QList<QDockWidget*> docks() const; ///< in the order of the menu
    void resetLayout();
    void restoreLayout();
    void saveLayout() const;

    enum class Trouble { None, Listening, Simulation };
    void showTrouble(Trouble kind, const QString& reason);
    void showStatus(const PlantSnapshot& snapshot);
    void showPointer(double x_m, double y_m);
    void addVehicleActions(const PlantLayout& layout);
    void focusNextPanel();
    void showAbout();

    MainWindow* q;
    Ui::MainWindow ui;
    std::unique_ptr<UwbScreens> uwb;
    AlarmScreen* alarms = nullptr; ///< owned by the window
    Theme theme = Theme::light();
    Appearance appearance = Appearance::System;
    StopKeyFilter* stopKeys = nullptr;
    QToolButton* stopAllButton = nullptr;
    QLabel* plantLabel = nullptr;
    QLabel* linksIcon = nullptr;
    QLabel* linksLabel = nullptr;
    QLabel* listeningLabel = nullptr;
    QLabel* pointerLabel = nullptr;
    PlantLayout plant;
    QString plantName;
    Trouble trouble = Trouble::None;
    QString troubleReason;
    ShiftLog shiftLog;
    std::optional<PlantSnapshot> lastStatus;
    bool ownPalette = false; ///< the application shows our palette instead of the desktop's
};

} // namespace agv::gui
