// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/map_widget.h"

#include "gui/map/map_agvs.h"
#include "gui/map/station_painter.h"
#include "gui/map/turn_painter.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace agv::gui {
namespace {

constexpr double zoomStep = 1.25;
constexpr double panStep_px = 60.0;

} // namespace

MapWidget::MapWidget(QWidget* parent) : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(240, 200);
    setAccessibleName(tr("Map of the plant"));
    setCursor(Qt::CrossCursor);
    m_static.setFont(font());
}

void MapWidget::setPlant(const PlantLayout& plant)
{
    m_plant = plant;
    m_tags = tagMapOf(m_plant);
    m_static.setPlant(&m_plant);
    m_uwbTrails.clear();
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

void MapWidget::setLayers(const StaticLayer::Options& options)
{
    m_static.setOptions(options);
    update();
}

void MapWidget::showSnapshot(const PlantSnapshot& snapshot)
{
    m_snapshot = snapshot;
    m_uwbTrails.add(snapshot);
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
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(drawingArea());
    // Small AGVs are symbols and must stay readable; large ones are see-through drawings.
    const bool large = m_viewport.scale() > 360.0;
    if (layers().stations)
        paintStationNames(painter, m_viewport, m_plant, stationNames(), m_theme);
    if (!large)
        paintReads(painter);
    paintAgvs(painter);
    if (large)
        paintReads(painter);
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        if (const TurnEstimate* estimate = shownEstimate(agv))
            paintStops(painter, m_viewport, *estimate, m_theme);
    }
    if (m_snapshot.uwb)
        paintUwbTags(painter, m_viewport, *m_snapshot.uwb, m_uwbTrails, m_theme);
    painter.restore();
    if (hasFocus() && m_keyboardFocus) {
        painter.setPen(QPen(m_theme.accent, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
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

void MapWidget::wheelEvent(QWheelEvent* event)
{
    m_viewport.zoomAt(event->position(), std::pow(zoomStep, event->angleDelta().y() / 120.0));
    userMoved();
    event->accept();
}

void MapWidget::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)
        return;
    m_press = m_last = event->position();
    m_dragging = false;
}

void MapWidget::mouseMoveEvent(QMouseEvent* event)
{
    const Point2 p = m_viewport.toPlant(event->position());
    emit pointerMoved(p.x, p.y);
    if (!(event->buttons() & (Qt::LeftButton | Qt::MiddleButton)))
        return;
    if (!m_dragging && (event->position() - m_press).manhattanLength() < 4.0)
        return;
    if (!m_dragging) {
        m_dragging = true;
        setFollowing(false);
        setCursor(Qt::ClosedHandCursor);
    }
    m_viewport.pan(event->position() - m_last);
    m_last = event->position();
    userMoved();
}

void MapWidget::mouseReleaseEvent(QMouseEvent* event)
{
    setCursor(Qt::CrossCursor);
    if (!m_dragging && event->button() == Qt::LeftButton) {
        if (const AgvSnapshot* agv = agvAt(event->position()))
            emit robotClicked(agv->id.number);
    }
    m_dragging = false;
}

void MapWidget::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (agvAt(event->position()))
        zoomToSelected();
}

void MapWidget::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left:
        m_viewport.pan({panStep_px, 0.0});
        break;
    case Qt::Key_Right:
        m_viewport.pan({-panStep_px, 0.0});
        break;
    case Qt::Key_Up:
        m_viewport.pan({0.0, panStep_px});
        break;
    case Qt::Key_Down:
        m_viewport.pan({0.0, -panStep_px});
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomIn();
        return;
    case Qt::Key_Minus:
        zoomOut();
        return;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    setFollowing(false);
    userMoved();
}

void MapWidget::focusInEvent(QFocusEvent* event)
{
    const Qt::FocusReason reason = event->reason();
    m_keyboardFocus =
        reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason;
    QWidget::focusInEvent(event);
}

void MapWidget::leaveEvent(QEvent*) { emit pointerLeft(); }

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
