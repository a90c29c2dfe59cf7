// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/map_widget.h"

#include "gui/map/accuracy_layer.h"
#include "gui/map/floor_tag_painter.h"
#include "gui/map/range_painter.h"
#include "gui/map/station_painter.h"
#include "gui/map/trail_painter.h"
#include "gui/map/turn_painter.h"
#include "gui/map/uwb_painter.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace agv::gui {
namespace {

constexpr double zoomStep = 1.25;

} // namespace

MapWidget::MapWidget(QWidget* parent) : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(240, 200);
    setAccessibleName(tr("Map of the plant"));
    setToolCursor();
    m_static.setFont(font());
}

void MapWidget::setPlant(const PlantLayout& plant)
{
    m_plant = plant;
    m_tags = tagMapOf(m_plant);
    m_static.setPlant(&m_plant);
    m_trails.clear();
    m_tagStates.clear();
    m_measured.reset();
    m_clickedTag.reset();
    fit();
}

void MapWidget::setUwbAnchors(const std::vector<UwbAnchor>& anchors)
{
    m_plant.anchors = anchors;
    m_static.setPlant(&m_plant);
    update();
}

void MapWidget::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_static.setTheme(theme);
    update();
}

void MapWidget::setLayers(const MapLayers& layers)
{
    m_static.setLayers(layers);
    update();
}

void MapWidget::setTrailLimit(const TrailLimit& limit)
{
    m_trails.setLimit(limit);
    update();
}

void MapWidget::showSnapshot(const PlantSnapshot& snapshot)
{
    m_snapshot = snapshot;
    m_trails.add(snapshot);
    m_tagStates.add(snapshot);
    follow();
    update();
}

void MapWidget::setSelectedRobot(int robot)
{
    m_selected = robot;
    follow();
    update();
}

QMarginsF MapWidget::fitMargins() const { return {rulerWidth + 24.0, 24.0, 24.0, rulerHeight + 24.0}; }

void MapWidget::fit()
{
    m_viewport.setSize(size());
    frameWholePlant();
    m_fitted = true;
    setFollowing(false);
    update();
}

void MapWidget::frameWholePlant()
{
    const QRectF area = areaOf(m_plant);
    m_viewport.fit(area, fitMargins());
    // Room to spare goes to the right, where the scale bar then hides nothing.
    const double left = m_viewport.toPixels(Point2{area.left(), 0.0}).x() - fitMargins().left();
    const double right = width() - m_viewport.toPixels(Point2{area.right(), 0.0}).x();
    m_viewport.pan({-std::clamp(scaleBarRoom - right, 0.0, std::max(0.0, left)), 0.0});
}

void MapWidget::zoomIn()
{
    m_viewport.zoomAt(rect().center(), zoomStep);
    userMoved();
}

void MapWidget::zoomOut()
{
    m_viewport.zoomAt(rect().center(), 1.0 / zoomStep);
    userMoved();
}

void MapWidget::zoomToSelected()
{
    const std::optional<Pose2> pose = drawnPose(m_selected);
    const AgvConfig* config = m_plant.findAgv({m_selected});
    if (!pose || !config)
        return;
    const double half = 2.2 * config->radius_m;
    m_viewport.fit(QRectF(pose->position.x - half, pose->position.y - half, 2.0 * half, 2.0 * half),
                   fitMargins());
    userMoved();
}

void MapWidget::centreOn(Point2 place)
{
    setFollowing(false);
    m_viewport.setCentre(place);
    userMoved();
}

void MapWidget::showPlace(Point2 place)
{
    constexpr double readableScale = 600.0; // px/m: the short ids stand beside the tags
    m_viewport.setScale(std::max(m_viewport.scale(), readableScale));
    centreOn(place);
}

void MapWidget::setFollowing(bool following)
{
    if (m_following == following)
        return;
    m_following = following;
    follow();
    update();
    emit followingChanged(following);
}

void MapWidget::userMoved()
{
    m_fitted = false;
    update();
}

void MapWidget::follow()
{
    const std::optional<Pose2> pose = m_following ? drawnPose(m_selected) : std::nullopt;
    if (!pose)
        return;
    m_fitted = false;
    // A move of less than a pixel would repaint the static layer for nothing.
    if (distance(pose->position, m_viewport.centre()) * m_viewport.scale() >= 1.0)
        m_viewport.setCentre(pose->position);
}

void MapWidget::paintEvent(QPaintEvent*)
{
    ++m_frames;
    QPainter painter(this);
    painter.drawImage(QPointF(), m_static.image(m_viewport, devicePixelRatioF()));
    paintAbove(painter);
    if (hasFocus() && m_keyboardFocus) {
        painter.setPen(QPen(m_theme.accent, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

void MapWidget::paintPicture(QPainter& painter)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    painter.setClipRect(rect());
    m_static.paintAt(painter, m_viewport);
    paintAbove(painter);
}

void MapWidget::paintAbove(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(drawingArea());
    paintMoving(painter);
    paintOverlays(painter);
    painter.restore();
}

void MapWidget::paintMoving(QPainter& painter) const
{
    // Small AGVs are symbols and must stay readable; large ones are see-through drawings.
    const bool large = m_viewport.scale() > 360.0;
    if (layers().floorTags)
        paintFloorTagMarks(painter, m_viewport, m_tagStates, m_plant.floorTags, m_plant.tagRadius_m, m_theme);
    if (layers().trails)
        paintTrails(painter, m_viewport, m_snapshot, m_trails, m_theme);
    if (layers().stations)
        paintStationNames(painter, m_viewport, m_plant, stationNames(), m_theme);
    if (!large)
        paintReads(painter);
    paintAgvs(painter);
    if (large)
        paintReads(painter);
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        if (const TurnEstimate* estimate = model::shownEstimate(agv))
            paintStops(painter, m_viewport, *estimate, m_theme);
    }
    if (const UwbTagSnapshot* tag = layers().ranges ? shownUwbTag() : nullptr)
        paintRanges(painter, m_viewport, *tag, m_plant.anchors, m_theme);
    if (m_snapshot.uwb && layers().uwbTags)
        paintUwbTags(painter, m_viewport, *m_snapshot.uwb, layers().uncertainty, m_theme);
}

void MapWidget::paintOverlays(QPainter& painter) const
{
    if (m_movingAnchor) {
        const QPointF at = m_viewport.toPixels(m_movedTo);
        painter.setPen(QPen(m_theme.accent, 1.6));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, 11.0, 11.0);
        painter.drawLine(at - QPointF(15.0, 0.0), at + QPointF(15.0, 0.0));
        painter.drawLine(at - QPointF(0.0, 15.0), at + QPointF(0.0, 15.0));
    }
    const QRectF area = areaOf(m_plant);
    const std::optional<QRectF> overview =
        layers().minimap ? m_minimap.place(m_viewport, area) : std::nullopt;
    if (overview)
        m_minimap.paint(painter, m_viewport, m_plant, area, m_snapshot, m_theme);
    if (layers().accuracy && !m_plant.anchors.empty())
        paintAccuracyLegend(painter, {width() - 8.0, overview ? overview->bottom() + 8.0 : 8.0}, m_theme);
    if (m_measured)
        paintMeasureLine(painter, m_viewport, *m_measured, m_theme);
}

const UwbTagSnapshot* MapWidget::shownUwbTag() const
{
    if (!m_snapshot.uwb)
        return nullptr;
    const std::vector<UwbTagSnapshot>& tags = m_snapshot.uwb->tags;
    const auto clicked = std::ranges::find(tags, m_clickedTag.value_or(-1), &UwbTagSnapshot::id);
    if (clicked != tags.end())
        return &*clicked;
    const auto own = std::ranges::find(tags, std::optional(RobotId{m_selected}), &UwbTagSnapshot::agv);
    return own == tags.end() ? nullptr : &*own;
}

void MapWidget::resizeEvent(QResizeEvent* event)
{
    m_viewport.setSize(event->size());
    if (m_fitted)
        frameWholePlant();
}

void MapWidget::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange ||
        event->type() == QEvent::LocaleChange) {
        m_static.setFont(font());
        setAccessibleName(tr("Map of the plant"));
        update();
    }
    QWidget::changeEvent(event);
}

bool MapWidget::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        const QString text = detailsAt(help->pos());
        if (text.isEmpty())
            QToolTip::hideText();
        else
            QToolTip::showText(help->globalPos(), text, this);
        return true;
    }
    return QWidget::event(event);
}

QRectF MapWidget::drawingArea() const
{
    return {rulerWidth, 0.0, width() - rulerWidth, height() - rulerHeight};
}

double MapWidget::readSize() const
{
    return std::clamp(m_viewport.toPixels(m_plant.tagRadius_m) * 1.25, 4.0, 16.0);
}

std::vector<QRectF> MapWidget::stationNames() const
{
    std::vector<QRectF> taken;
    const auto take = [&taken](QPointF centre, double half) {
        taken.emplace_back(centre - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half));
    };
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        const AgvConfig* config = m_plant.findAgv(agv.id);
        const std::optional<Pose2> pose = drawnPose(agv.id.number);
        if (config && pose)
            take(m_viewport.toPixels(pose->position), m_viewport.toPixels(config->radius_m));
        for (const TagRead& read : agv.recentReads) {
            if (const auto found = m_tags.find(read.uid); found != m_tags.end())
                take(m_viewport.toPixels(found->second), readSize());
        }
    }
    return placeStationNames(QFontMetricsF(font()), m_viewport, m_plant, drawingArea(), taken);
}

} // namespace agv::gui
