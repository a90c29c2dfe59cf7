// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/main_window.h"

#include "gui/glyphs.h"
#include "gui/main_window_private.h"
#include "gui/shortcut_dialog.h"
#include "model/messages.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDateTime>
#include <QMessageBox>
#include <QSettings>

namespace agv::gui {

MainWindow::MainWindow(const PlantLayout& plant, QWidget* parent)
    : QMainWindow(parent),
      d(std::make_unique<Private>(this))
{
    d->build(plant);
    d->connectActions();
    d->applyTheme();
    d->resetLayout();
    d->restoreLayout();
    d->retranslate();
}

// A field that loses its focus because the window goes away reports to a window that is half gone.
MainWindow::~MainWindow()
{
    d->ui.calibration->disconnect(this);
    d->ui.jog->disconnect(this);
}

void MainWindow::showSnapshot(const PlantSnapshot& snapshot)
{
    d->ui.map->showSnapshot(snapshot);
    d->ui.links->showSnapshot(snapshot);
    d->ui.calibration->showSnapshot(snapshot);
    d->ui.jog->showSnapshot(snapshot);
    d->uwb->showSnapshot(snapshot);
    d->alarms->showSnapshot(snapshot);
    d->ui.shift->showSnapshot(snapshot);
    d->ui.plots->showSnapshot(snapshot);
    d->ui.floorTags->showSnapshot(snapshot);
    d->showStatus(snapshot);
    for (const EventEntry& line : d->shiftLog.linesFor(snapshot, QDateTime::currentMSecsSinceEpoch()))
        addEvent(line);
}

void MainWindow::addEvent(const EventEntry& event) { d->ui.events->addEvent(event); }

void MainWindow::showListenFailure(const QString& reason)
{
    d->showTrouble(Private::Trouble::Listening, reason);
}

void MainWindow::showListening()
{
    if (d->trouble == Private::Trouble::Listening)
        d->showTrouble(Private::Trouble::None, {});
}

void MainWindow::showTurnTimeKept(int robot, EventLevel level, const QString& sentence)
{
    const std::string text = sentence.toStdString();
    addEvent({QDateTime::currentMSecsSinceEpoch(), level, "AGV " + std::to_string(robot), text});
    d->ui.calibration->showKept(robot, model::Messages::sentence(text));
}

void MainWindow::showSimulationEnd(const QString& reason)
{
    d->showTrouble(Private::Trouble::Simulation, reason);
}

void MainWindow::takeImportedUwb(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings,
                                 const QStringList& notes)
{
    d->uwb->takeImported(anchors, settings, notes);
}

void MainWindow::setUwbSavable(bool savable) { d->uwb->setSavable(savable); }

void MainWindow::showUwbSaved(bool saved, const QString& sentence) { d->uwb->showSaved(saved, sentence); }

void MainWindow::showUwbNote(EventLevel level, const QString& sentence) { d->uwb->showNote(level, sentence); }

void MainWindow::showAnchorSurvey(const AnchorSurvey& survey) { d->uwb->showSurvey(survey); }

void MainWindow::showSerialPorts(const std::vector<SerialPortInfo>& ports) { d->uwb->showPorts(ports); }

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!d->uwb->mayClose()) {
        event->ignore();
        return;
    }
    d->saveLayout();
    QMainWindow::closeEvent(event);
}

void MainWindow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        d->ui.retranslateUi(this);
        d->retranslate();
    } else if (event->type() == QEvent::ApplicationPaletteChange) {
        d->onPaletteChange();
    }
    QMainWindow::changeEvent(event);
}

} // namespace agv::gui
