// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/map_controls.h"

#include "gui/picture_file.h"
#include "model/messages.h"
#include "model/words.h"
#include "ui_main_window.h"

#include <QActionGroup>
#include <QClipboard>
#include <QFileDialog>
#include <QGuiApplication>
#include <QMenu>
#include <QPainter>
#include <QSettings>

#include <iterator>

namespace agv::gui {
namespace {

struct LayerSwitch {
    QAction* Ui::MainWindow::* action;
    bool MapLayers::* layer;
    const char* key; ///< in the settings
};

constexpr LayerSwitch layerSwitches[] = {
    {&Ui::MainWindow::gridAction, &MapLayers::grid, "map/grid"},
    {&Ui::MainWindow::tagsAction, &MapLayers::floorTags, "map/floorTags"},
    {&Ui::MainWindow::stationsAction, &MapLayers::stations, "map/stations"},
    {&Ui::MainWindow::anchorsAction, &MapLayers::anchors, "map/anchors"},
    {&Ui::MainWindow::uwbTagsAction, &MapLayers::uwbTags, "map/uwbTags"},
    {&Ui::MainWindow::trailsAction, &MapLayers::trails, "map/trails"},
    {&Ui::MainWindow::uncertaintyAction, &MapLayers::uncertainty, "map/uncertainty"},
    {&Ui::MainWindow::rangesAction, &MapLayers::ranges, "map/ranges"},
    {&Ui::MainWindow::accuracyAction, &MapLayers::accuracy, "map/accuracy"},
    {&Ui::MainWindow::minimapAction, &MapLayers::minimap, "map/minimap"},
};

struct TrailChoice {
    QAction* Ui::MainWindow::* action;
    TrailLimit limit;
};

constexpr TrailChoice trailChoices[] = {
    {&Ui::MainWindow::trail10sAction, {10.0, {}}},    {&Ui::MainWindow::trail1minAction, {60.0, {}}},
    {&Ui::MainWindow::trail10minAction, {600.0, {}}}, {&Ui::MainWindow::trail2mAction, {{}, 2.0}},
    {&Ui::MainWindow::trail10mAction, {{}, 10.0}},
};
constexpr int usualTrail = 1; ///< one minute
constexpr auto trailKey = "map/trail";

} // namespace

MapControls::MapControls(Ui::MainWindow& ui, QWidget* window)
    : QObject(window),
      m_ui(ui),
      m_window(window),
      m_map(ui.map)
{
    connectView();
    connectLayers();
    connectTrails();
    connectTools();
    connectPictures();
    connect(m_map, &MapWidget::menuRequested, this, &MapControls::showMenu);
}

void MapControls::connectView()
{
    connect(m_map, &MapWidget::followingChanged, m_ui.followAction, &QAction::setChecked);
    connect(m_ui.fitAction, &QAction::triggered, m_map, &MapWidget::fit);
    connect(m_ui.zoomInAction, &QAction::triggered, m_map, &MapWidget::zoomIn);
    connect(m_ui.zoomOutAction, &QAction::triggered, m_map, &MapWidget::zoomOut);
    connect(m_ui.zoomToAction, &QAction::triggered, m_map, &MapWidget::zoomToSelected);
    connect(m_ui.followAction, &QAction::toggled, m_map, &MapWidget::setFollowing);
}

void MapControls::connectLayers()
{
    const QSettings settings;
    const MapLayers usual;
    for (const LayerSwitch& entry : layerSwitches) {
        QAction* action = m_ui.*entry.action;
        action->setChecked(settings.value(QLatin1String(entry.key), usual.*entry.layer).toBool());
        connect(action, &QAction::toggled, this, [this, &entry](bool on) {
            QSettings().setValue(QLatin1String(entry.key), on);
            updateLayers();
        });
    }
    updateLayers();
}

void MapControls::updateLayers()
{
    MapLayers layers;
    for (const LayerSwitch& entry : layerSwitches)
        layers.*entry.layer = (m_ui.*entry.action)->isChecked();
    m_map->setLayers(layers);
}

void MapControls::connectTrails()
{
    auto* group = new QActionGroup(this);
    for (const TrailChoice& choice : trailChoices) {
        group->addAction(m_ui.*choice.action);
        connect(m_ui.*choice.action, &QAction::triggered, this, [this, &choice] {
            m_map->setTrailLimit(choice.limit);
            QSettings().setValue(QLatin1String(trailKey), static_cast<int>(&choice - trailChoices));
        });
    }
    const int kept = QSettings().value(QLatin1String(trailKey), usualTrail).toInt();
    const TrailChoice& choice =
        trailChoices[kept >= 0 && kept < static_cast<int>(std::size(trailChoices)) ? kept : usualTrail];
    (m_ui.*choice.action)->setChecked(true);
    m_map->setTrailLimit(choice.limit);
}

void MapControls::connectTools()
{
    const auto tool = [this](QAction* action, MapTool own) {
        connect(action, &QAction::triggered, this,
                [this, own](bool on) { m_map->setTool(on ? own : MapTool::Select); });
        connect(m_map, &MapWidget::toolChanged, action,
                [action, own](MapTool chosen) { action->setChecked(chosen == own); });
    };
    tool(m_ui.measureAction, MapTool::Measure);
    tool(m_ui.moveAnchorsAction, MapTool::MoveAnchors);
}

void MapControls::connectPictures()
{
    connect(m_ui.copyMapAction, &QAction::triggered, this, &MapControls::copyPicture);
    connect(m_ui.saveMapAction, &QAction::triggered, this, &MapControls::askForPicture);
}

void MapControls::showMenu(QPoint position, Point2 place)
{
    auto* menu = new QMenu(m_window);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const QString coordinates =
        tr("x %1, y %2").arg(model::Words::millimetres(place.x), model::Words::millimetres(place.y));
    connect(menu->addAction(tr("Copy %1").arg(coordinates)), &QAction::triggered, this,
            [coordinates] { QGuiApplication::clipboard()->setText(coordinates); });
    connect(menu->addAction(tr("Measure from here")), &QAction::triggered, this,
            [this, place] { m_map->measureFrom(place); });
    connect(menu->addAction(tr("Centre here")), &QAction::triggered, this,
            [this, place] { m_map->centreOn(place); });
    menu->addSeparator();
    for (QAction* action : {m_ui.fitAction, m_ui.followAction})
        menu->addAction(action);
    menu->addMenu(m_ui.layerMenu);
    menu->addMenu(m_ui.trailMenu);
    menu->addSeparator();
    for (QAction* action : {m_ui.measureAction, m_ui.moveAnchorsAction})
        menu->addAction(action);
    menu->addSeparator();
    for (QAction* action : {m_ui.copyMapAction, m_ui.saveMapAction})
        menu->addAction(action);
    menu->popup(position);
}

void MapControls::copyPicture() { QGuiApplication::clipboard()->setPixmap(m_map->grab()); }

void MapControls::askForPicture()
{
    // Qt's own dialog, not modal: Stop all stays in reach.
    auto* dialog = new QFileDialog(m_window, tr("Save the map as a picture"));
    dialog->setObjectName(QStringLiteral("mapPictureDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(pictureFilters());
    dialog->setDefaultSuffix(QStringLiteral("png"));
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.section(QLatin1Char('.'), -1).chopped(1));
    });
    connect(dialog, &QFileDialog::fileSelected, this, &MapControls::savePictureAs);
    dialog->show();
}

void MapControls::savePictureAs(const QString& path)
{
    const Result<void> saved =
        savePicture(path, m_map->size(), [this](QPainter& painter) { m_map->paintPicture(painter); });
    emit pictureSaved(saved.has_value(), saved ? tr("The map was saved as %1").arg(path)
                                               : model::Messages::sentence(saved.error().detail));
}

} // namespace agv::gui
