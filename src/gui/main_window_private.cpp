// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/main_window_private.h"

#include "gui/cell_delegates.h"
#include "gui/glyphs.h"
#include "gui/hint_table_view.h"
#include "gui/jog_pad.h"
#include "gui/map/map_controls.h"
#include "gui/next_step.h"
#include "gui/shortcut_dialog.h"
#include "model/messages.h"
#include "model/words.h"

#include <QActionGroup>
#include <QApplication>
#include <QDateTime>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>
#include <QStorageInfo>

#include <utility>

namespace agv::gui {

using model::Words;

void MainWindow::Private::build(const PlantLayout& described)
{
    ui.setupUi(q);
    plant = described;
    plantName = QString::fromStdString(plant.name);
    ui.simulationBanner->hide();
    ui.noticeBar->hide();
    ui.nextStepLabel->hide();
    ui.map->setPlant(plant);
    ui.calibration->setPlant(plant);
    ui.shift->setPlant(plant);
    ui.floorTags->setPlant(plant);
    ui.jog->setPlant(plant);
    uwb = std::make_unique<UwbScreens>(ui, q);
    uwb->setPlant(plant);
    alarms = new AlarmScreen(ui, q);
    addVehicleActions(plant);
    ui.map->setSelectedRobot(ui.calibration->robot());
    q->setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    q->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);

    linksIcon = new QLabel;
    linksLabel = new QLabel;
    stopAllButton = new QToolButton;
    stopAllButton->setObjectName(QStringLiteral("stopAllButton"));
    stopAllButton->setDefaultAction(ui.stopAllAction);
    stopAllButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    stopAllButton->setFocusPolicy(Qt::StrongFocus);
    // A bar of its own with a single widget: in a narrow window the other bar folds its buttons away, this
    // one never does.
    auto* always = new QWidget;
    auto* layout = new QHBoxLayout(always);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addStretch();
    layout->addWidget(linksIcon);
    layout->addWidget(linksLabel);
    layout->addSpacing(12);
    layout->addWidget(alarms->button());
    layout->addSpacing(12);
    layout->addWidget(stopAllButton);
    always->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    ui.stopBar->addWidget(always);
    for (QToolBar* bar : {ui.toolBar, ui.stopBar})
        bar->toggleViewAction()->setVisible(false);

    listeningLabel = new QLabel;
    pointerLabel = new QLabel;
    plantLabel = new QLabel;
    ui.statusBar->addWidget(plantLabel);
    ui.statusBar->addWidget(listeningLabel);
    ui.statusBar->addPermanentWidget(pointerLabel);
    for (QDockWidget* dock : docks())
        ui.panelMenu->addAction(dock->toggleViewAction());
}

void MainWindow::Private::connectActions()
{
    auto* appearances = new QActionGroup(q);
    for (QAction* action : {ui.systemThemeAction, ui.lightThemeAction, ui.darkThemeAction})
        appearances->addAction(action);
    appearance = static_cast<Appearance>(QSettings().value(QStringLiteral("window/appearance"), 0).toInt());
    appearances->actions().value(static_cast<int>(appearance), ui.systemThemeAction)->setChecked(true);
    connect(appearances, &QActionGroup::triggered, q, [this, appearances](QAction* action) {
        setAppearance(static_cast<Appearance>(appearances->actions().indexOf(action)));
    });

    stopKeys = new StopKeyFilter(q);
    connect(stopKeys, &StopKeyFilter::stopPressed, q, &MainWindow::stopAllRequested);
    connect(ui.stopAllAction, &QAction::triggered, q, &MainWindow::stopAllRequested);
    connect(ui.quitAction, &QAction::triggered, q, &QWidget::close);

    connect(ui.links, &LinksPanel::openReaderRequested, q, &MainWindow::openReaderRequested);
    connect(ui.links, &LinksPanel::closeReaderRequested, q, &MainWindow::closeReaderRequested);
    connect(ui.links, &LinksPanel::openUwbRequested, q, &MainWindow::openUwbRequested);
    connect(ui.links, &LinksPanel::closeUwbRequested, q, &MainWindow::closeUwbRequested);
    CalibrationPanel* calibration = ui.calibration;
    connect(calibration, &CalibrationPanel::startTurnRequested, q, &MainWindow::startTurnRequested);
    connect(calibration, &CalibrationPanel::abortTurnRequested, q, &MainWindow::abortTurnRequested);
    connect(calibration, &CalibrationPanel::retakeStopRequested, q, &MainWindow::retakeStopRequested);
    connect(calibration, &CalibrationPanel::turnTimeChanged, q, &MainWindow::turnTimeChanged);
    connect(calibration, &CalibrationPanel::turnSpeedChanged, q, &MainWindow::turnSpeedChanged);
    connect(calibration, &CalibrationPanel::turnTimeApplied, q, &MainWindow::turnTimeApplied);
    connect(calibration, &CalibrationPanel::robotChosen, ui.map, &MapWidget::setSelectedRobot);
    connectJog();
    connect(calibration, &CalibrationPanel::actionsChanged, q, [this] {
        ui.initialiseAction->setEnabled(ui.calibration->canStart());
        ui.initialiseAction->setIconText(tr("Calibrate %1").arg(ui.calibration->robotName()));
        ui.abortAction->setEnabled(ui.calibration->canAbort());
    });
    connect(ui.initialiseAction, &QAction::triggered, calibration, &CalibrationPanel::initialise);
    connect(ui.abortAction, &QAction::triggered, calibration, &CalibrationPanel::abort);

    MapWidget* map = ui.map;
    connect(map, &MapWidget::robotClicked, calibration, &CalibrationPanel::setRobot);
    connect(map, &MapWidget::pointerMoved, q, [this](double x_m, double y_m) { showPointer(x_m, y_m); });
    connect(map, &MapWidget::pointerLeft, pointerLabel, &QLabel::clear);
    auto* mapControls = new MapControls(ui, q);
    const auto logSaved = [this](bool saved, const QString& sentence) {
        q->addEvent({QDateTime::currentMSecsSinceEpoch(), saved ? EventLevel::Info : EventLevel::Error,
                     "Console", sentence.toStdString()});
    };
    connect(mapControls, &MapControls::pictureSaved, q, logSaved);
    connect(ui.plots, &PlotPanel::exported, q, logSaved);
    connect(ui.floorTags, &FloorTagPanel::placeChosen, map, &MapWidget::showPlace);

    connect(ui.nextPanelAction, &QAction::triggered, q, [this] { focusNextPanel(); });
    connect(ui.resetLayoutAction, &QAction::triggered, q, [this] { resetLayout(); });
    connect(ui.fullScreenAction, &QAction::toggled, q,
            [this](bool on) { q->setWindowState(q->windowState().setFlag(Qt::WindowFullScreen, on)); });
    connect(ui.shortcutsAction, &QAction::triggered, q, [this] {
        auto* dialog =
            new ShortcutDialog(q->findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly), q);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    connect(ui.aboutAction, &QAction::triggered, q, [this] { showAbout(); });
    ui.initialiseAction->setEnabled(false);
    ui.abortAction->setEnabled(false);
    connectShift();
    connectSimulationMenu();
}

void MainWindow::Private::connectShift()
{
    ui.shift->setFactsSource([] {
        const QString folder = QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
        return model::ShiftFacts{QStorageInfo(folder).bytesAvailable()};
    });
    connect(ui.shift, &ShiftPanel::turnWanted, q, [this](int robot) {
        ui.calibration->setRobot(robot);
        ui.calibration->initialise();
    });
    connect(ui.shift, &ShiftPanel::abortWanted, q, &MainWindow::abortTurnRequested);
    connect(q, &MainWindow::stopAllRequested, ui.shift, &ShiftPanel::stop);
    connect(ui.shift, &ShiftPanel::verdictReached, q, [this](bool good, const QString& sentence) {
        q->addEvent({QDateTime::currentMSecsSinceEpoch(), good ? EventLevel::Info : EventLevel::Warning,
                     "Console", sentence.toStdString()});
    });
    connect(ui.checkShiftAction, &QAction::triggered, q, [this] {
        ui.shiftDock->show();
        ui.shiftDock->raise();
        ui.shift->check();
    });
}

void MainWindow::Private::connectJog()
{
    JogPanel* jog = ui.jog;
    connect(jog, &JogPanel::pressed, q, &MainWindow::jogPressed);
    connect(jog, &JogPanel::held, q, &MainWindow::jogHeld);
    connect(jog, &JogPanel::released, q, &MainWindow::jogReleased);
    connect(jog, &JogPanel::stopRequested, q, &MainWindow::stopRequested);
    connect(jog, &JogPanel::dockRequested, q, &MainWindow::dockRequested);
    connect(jog, &JogPanel::stopAllReleased, q, &MainWindow::stopAllReleased);
    connect(jog, &JogPanel::robotChosen, ui.calibration, &CalibrationPanel::setRobot);
    connect(ui.calibration, &CalibrationPanel::robotChosen, jog, &JogPanel::setRobot);
    connect(ui.jogDock, &QDockWidget::visibilityChanged, jog, &JogPanel::setSeen);
    connect(ui.driveAction, &QAction::triggered, q, [this] {
        ui.jogDock->show();
        ui.jogDock->raise();
        ui.jog->pad()->setFocus(Qt::ShortcutFocusReason);
    });
}

void MainWindow::Private::connectSimulationMenu()
{
    const std::pair<QAction*, const char*> faults[] = {
        {ui.cutReaderAction, "cut reader %1 10"},
        {ui.cutRobotAction, "cut robot %1 10"},
        {ui.robotErrorAction, "robot-error %1"},
        {ui.garbageAction, "garbage reader %1 300"},
        {ui.weakBatteryAction, "battery %1 10"},
        {ui.deadTagsAction, "deadtag random 20"},
        {ui.restoreAction, "restore"},
    };
    for (const auto& [action, command] : faults) {
        connect(action, &QAction::triggered, q, [this, text = QString::fromLatin1(command)] {
            QString line = text;
            emit q->simulationCommandRequested(
                line.replace(QLatin1String("%1"), QString::number(ui.calibration->robot())));
        });
    }
    ui.simulationMenu->menuAction()->setVisible(false);
}

void MainWindow::Private::setAppearance(Appearance chosen)
{
    appearance = chosen;
    QSettings().setValue(QStringLiteral("window/appearance"), static_cast<int>(chosen));
    applyTheme();
}

void MainWindow::Private::applyTheme()
{
    // The whole program gets the chosen colours, dialogs too; as the desktop means its own palette untouched.
    const QPalette chosen = appearance == Appearance::Light  ? Theme::light().toPalette()
                            : appearance == Appearance::Dark ? Theme::darkTheme().toPalette()
                                                             : QPalette();
    if (appearance != Appearance::System || ownPalette) {
        ownPalette = appearance != Appearance::System;
        QApplication::setPalette(chosen);
    }
    theme = appearance == Appearance::Light  ? Theme::light()
            : appearance == Appearance::Dark ? Theme::darkTheme()
                                             : Theme::fromPalette(QGuiApplication::palette());
    q->setPalette(theme.toPalette());
    q->setStyleSheet(theme.styleSheet());
    ui.map->setTheme(theme);
    ui.links->setTheme(theme);
    ui.calibration->setTheme(theme);
    ui.shift->setTheme(theme);
    ui.plots->setTheme(theme);
    ui.floorTags->setTheme(theme);
    ui.jog->setTheme(theme);
    ui.events->setTheme(theme);
    uwb->setTheme(theme);
    alarms->setTheme(theme);
    const std::pair<QAction*, Glyph> icons[] = {
        {ui.fitAction, Glyph::Fit},         {ui.zoomInAction, Glyph::ZoomIn},
        {ui.zoomOutAction, Glyph::ZoomOut}, {ui.zoomToAction, Glyph::ZoomTo},
        {ui.followAction, Glyph::Target},   {ui.initialiseAction, Glyph::Turn},
        {ui.abortAction, Glyph::Abort},
    };
    for (const auto& [action, glyph] : icons)
        action->setIcon(glyphIcon(glyph, theme.text, theme.disabledText));
    ui.stopAllAction->setIcon(glyphIcon(Glyph::Stop, theme.stopText, theme.stopText));
    ui.toolBar->setIconSize(QSize(18, 18));
    stopAllButton->setIconSize(QSize(18, 18));
    const std::optional<PlantSnapshot> status = std::exchange(lastStatus, std::nullopt);
    if (status)
        showStatus(*status);
    showTrouble(trouble, troubleReason);
}

void MainWindow::Private::onPaletteChange()
{
    // Our own setPalette() comes back as this event; only the desktop's news matter.
    if (appearance == Appearance::System && Theme::fromPalette(QGuiApplication::palette()).dark != theme.dark)
        applyTheme();
}

void MainWindow::Private::addVehicleActions(const PlantLayout& layout)
{
    for (const AgvConfig& agv : layout.agvs) {
        const int robot = agv.id.number;
        auto* action = new QAction(QString::fromStdString(agv.name), q);
        action->setObjectName(QStringLiteral("chooseAgv%1Action").arg(robot));
        if (agv.name.empty())
            action->setText(tr("AGV %1").arg(robot));
        action->setProperty("agv", robot);
        if (robot < 10)
            action->setShortcut(QKeySequence(QStringLiteral("Alt+%1").arg(robot)));
        connect(action, &QAction::triggered, ui.calibration,
                [this, robot] { ui.calibration->setRobot(robot); });
        ui.chooseMenu->addAction(action);
        q->addAction(action);
    }
}

void MainWindow::Private::showTrouble(Trouble kind, const QString& reason)
{
    trouble = kind;
    troubleReason = reason;
    ui.noticeBar->setVisible(kind != Trouble::None);
    const QString text = model::Messages::sentence(reason.toStdString());
    ui.noticeLabel->setText(
        kind == Trouble::Listening
            ? tr("<b>No robot can connect.</b> %1. It is tried again by itself.").arg(text.toHtmlEscaped())
            : tr("<b>The simulation has ended.</b> %1. Start the "
                 "console again.")
                  .arg(text.toHtmlEscaped()));
    ui.noticeIcon->setPixmap(
        glyphIcon(Glyph::Error, theme.error, theme.error).pixmap(QSize(20, 20), q->devicePixelRatioF()));
    if (lastStatus)
        showStatus(PlantSnapshot(*lastStatus));
}

void MainWindow::Private::showStatus(const PlantSnapshot& snapshot)
{
    const model::LinkTableModel& links = ui.links->links();
    const int up = links.countIn(LinkState::Up);
    const int broken = links.countIn(LinkState::Failed) + links.countIn(LinkState::Silent) +
                       links.countIn(LinkState::Waiting);
    const int all = links.rowCount();
    const Glyph glyph = broken > 0 ? Glyph::Warning : up == all ? Glyph::LinkUp : Glyph::LinkDown;
    linksLabel->setText(broken > 0 ? tr("Links: %1 of %2 up, %3 disturbed").arg(up).arg(all).arg(broken)
                                   : tr("Links: %1 of %2 up").arg(up).arg(all));
    const QColor colour = broken > 0 ? theme.warning : theme.mutedText;
    if (!lastStatus || linksIcon->property("glyph").toInt() != static_cast<int>(glyph)) {
        linksIcon->setProperty("glyph", static_cast<int>(glyph));
        linksIcon->setPixmap(glyphIcon(glyph, colour, colour).pixmap(QSize(16, 16), q->devicePixelRatioF()));
    }
    listeningLabel->setText(
        trouble == Trouble::Listening
            ? tr("Robots cannot connect")
            : tr("Robots connect to: %1").arg(model::Messages::sentence(snapshot.listening)));
    listeningLabel->setVisible(!snapshot.listening.empty());
    ui.simulationBanner->setVisible(snapshot.simulated);
    ui.simulationMenu->menuAction()->setVisible(snapshot.simulated);
    const QString warning = NextStep::warning(snapshot).toHtmlEscaped();
    const QString next =
        trouble == Trouble::None ? NextStep::text(plant, snapshot).toHtmlEscaped() : QString();
    const QString both = warning.isEmpty() ? next : QStringLiteral("<b>%1</b> %2").arg(warning, next);
    ui.nextStepLabel->setText(both);
    ui.nextStepLabel->setVisible(!both.isEmpty());
    lastStatus = snapshot;
}

void MainWindow::Private::showPointer(double x_m, double y_m)
{
    pointerLabel->setText(tr("x %1   y %2").arg(Words::millimetres(x_m), Words::millimetres(y_m)));
}

void MainWindow::Private::retranslate()
{
    q->setWindowTitle(plantName.isEmpty() ? tr("AGV Console[*]") : tr("%1[*] – AGV Console").arg(plantName));
    plantLabel->setText(tr("Plant: %1").arg(plantName));
    plantLabel->setVisible(!plantName.isEmpty());
    stopAllButton->setText(tr("Stop all"));
    const QString tip = tr("Stop all AGVs now (Esc). Software stop, does not replace the emergency stop.");
    ui.stopAllAction->setToolTip(tip);
    stopAllButton->setToolTip(tip);
    stopAllButton->setAccessibleName(tr("Stop all"));
    stopAllButton->setAccessibleDescription(tip);
    uwb->retranslate();
    alarms->retranslate();
    showTrouble(trouble, troubleReason);
}

void MainWindow::Private::showAbout()
{
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About AGV Console"),
        tr("<b>AGV Console</b><p>Locate, calibrate and watch the AGVs of a pipeless plant.</p>"
           "<p>Free software under the GNU General Public License, version 3 or later. "
           "Made with Qt, QCustomPlot and Eigen.</p>"),
        QMessageBox::Close, q);
    box->setIconPixmap(applicationIcon().pixmap(64));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace agv::gui
