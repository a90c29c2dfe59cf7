// SPDX-License-Identifier: GPL-3.0-or-later
// Where the panels of the window stand, and the way of the keyboard through them.
#include "gui/hint_table_view.h"
#include "gui/jog_pad.h"
#include "gui/main_window_private.h"

#include <QApplication>
#include <QSettings>

#include <utility>

namespace agv::gui {
namespace {

constexpr int layoutVersion = 6; ///< raised when docks or tool bars come or change their names

} // namespace

void MainWindow::Private::focusNextPanel()
{
    const auto field = [](const QWidget* panel, const char* name) {
        return panel->findChild<QWidget*>(QString::fromLatin1(name));
    };
    // Each with the first of its fields that takes the keyboard; the map takes it itself.
    const std::pair<QWidget*, QWidget*> panels[] = {{ui.map, ui.map},
                                                    {ui.links, field(ui.links, "linkTable")},
                                                    {ui.calibration, field(ui.calibration, "robotCombo")},
                                                    {ui.shift, field(ui.shift, "checkButton")},
                                                    {ui.jog, ui.jog->pad()},
                                                    {ui.plots, field(ui.plots, "groupCombo")},
                                                    {ui.events, field(ui.events, "table")},
                                                    {ui.alarms, field(ui.alarms, "alarmTable")},
                                                    {ui.floorTags, field(ui.floorTags, "floorTagTable")},
                                                    {ui.anchors, ui.anchors->table()},
                                                    {ui.uwbTags, ui.uwbTags->table()}};
    const QWidget* focus = QApplication::focusWidget();
    const std::size_t count = std::size(panels);
    std::size_t current = count - 1;
    for (std::size_t i = 0; i < count; ++i) {
        if (focus && (panels[i].first == focus || panels[i].first->isAncestorOf(focus)))
            current = i;
    }
    for (std::size_t step = 1; step <= count; ++step) {
        const auto& [panel, target] = panels[(current + step) % count];
        // A dock behind another one counts as visible, but nothing of it is to be seen.
        if (!panel->isVisible() || panel->visibleRegion().isEmpty())
            continue;
        target->setFocus(Qt::ShortcutFocusReason);
        return;
    }
}

QList<QDockWidget*> MainWindow::Private::docks() const
{
    return {ui.linksDock,  ui.calibrationDock, ui.shiftDock,     ui.jogDock,     ui.plotsDock,
            ui.eventsDock, ui.alarmsDock,      ui.floorTagsDock, ui.anchorsDock, ui.tagsDock};
}

void MainWindow::Private::resetLayout()
{
    for (QDockWidget* dock : docks()) {
        dock->setFloating(false);
        dock->show();
    }
    q->addDockWidget(Qt::LeftDockWidgetArea, ui.linksDock);
    q->addDockWidget(Qt::RightDockWidgetArea, ui.calibrationDock);
    q->tabifyDockWidget(ui.calibrationDock, ui.shiftDock);
    q->tabifyDockWidget(ui.shiftDock, ui.jogDock);
    q->tabifyDockWidget(ui.jogDock, ui.plotsDock);
    ui.calibrationDock->raise();
    q->addDockWidget(Qt::BottomDockWidgetArea, ui.eventsDock);
    q->tabifyDockWidget(ui.eventsDock, ui.alarmsDock);
    q->tabifyDockWidget(ui.alarmsDock, ui.floorTagsDock);
    q->tabifyDockWidget(ui.floorTagsDock, ui.anchorsDock);
    q->tabifyDockWidget(ui.anchorsDock, ui.tagsDock);
    ui.eventsDock->raise();
    const int em = q->fontMetrics().horizontalAdvance(QLatin1Char('0'));
    q->resizeDocks({ui.linksDock, ui.calibrationDock}, {45 * em, 52 * em}, Qt::Horizontal);
    q->resizeDocks({ui.eventsDock}, {13 * q->fontMetrics().height()}, Qt::Vertical);
}

void MainWindow::Private::restoreLayout()
{
    const QSettings settings;
    q->restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    q->restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), layoutVersion);
    ui.toolBar->show();
    ui.stopBar->show();
}

void MainWindow::Private::saveLayout() const
{
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), q->saveGeometry());
    settings.setValue(QStringLiteral("window/state"), q->saveState(layoutVersion));
}

} // namespace agv::gui
