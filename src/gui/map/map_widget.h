// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "gui/map/static_layer.h"
#include "gui/map/uwb_painter.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

namespace agv::gui {

/// The plan of the plant. What stands still is an image painted once per view (StaticLayer); what moves is
/// painted over it for every snapshot. GUI thread; no OpenGL, no scene graph.
/// Mouse: wheel zooms to the pointer, dragging pans, a click selects an AGV, resting shows details.
/// Keys: arrows pan, + and - zoom.
class MapWidget : public QWidget {
    Q_OBJECT
public:
    explicit MapWidget(QWidget* parent = nullptr);

    void setPlant(const PlantLayout& plant);
    /// Anchors that stand elsewhere now; the view stays.
    void setUwbAnchors(const std::vector<UwbAnchor>& anchors);
    void setTheme(const Theme& theme);
    void showSnapshot(const PlantSnapshot& snapshot);
    void setSelectedRobot(int robot);

    const Viewport& viewport() const { return m_viewport; }
    int staticPaintCount() const { return m_static.paintCount(); }
    int framePaintCount() const { return m_frames; }
    StaticLayer::Options layers() const { return m_static.options(); }
    void setLayers(const StaticLayer::Options& options);

    /// Details of what lies under `pixel`: floor tag, AGV, stop, UWB tag or anchor, station; empty when
    /// nothing does.
    QString detailsAt(QPointF pixel) const;
    /// Pose of an AGV as drawn: a running turn's preview before the last known pose.
    std::optional<Pose2> drawnPose(int robot) const;
    /// Where the stations' names stand, px, in the plant's order: clear of AGVs and of tags being read.
    std::vector<QRectF> stationNames() const;
    /// Half the width of the diamond of a tag that is being read, px.
    double readSize() const;

public slots:
    void fit();
    void zoomIn();
    void zoomOut();
    void zoomToSelected();
    void setFollowing(bool following);

signals:
    void robotClicked(int robot);
    void followingChanged(bool following);
    void pointerMoved(double x_m, double y_m);
    void pointerLeft();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    QMarginsF fitMargins() const;
    QRectF drawingArea() const; ///< without the rulers
    void frameWholePlant();
    void userMoved();
    void follow();
    const AgvSnapshot* agvAt(QPointF pixel) const;
    QString agvDetails(const AgvSnapshot& agv) const;
    QString stopDetails(QPointF pixel) const;
    QString tagDetails(QPointF pixel) const;
    QString uwbTagDetails(QPointF pixel) const;
    QString anchorDetails(QPointF pixel) const;
    QString stationDetails(QPointF pixel) const;
    void paintReads(QPainter& painter) const;
    void paintAgvs(QPainter& painter) const;

    PlantLayout m_plant;
    TagMap m_tags;
    PlantSnapshot m_snapshot;
    UwbTrails m_uwbTrails;
    StaticLayer m_static;
    Viewport m_viewport;
    Theme m_theme = Theme::light();
    int m_selected = 0;
    int m_frames = 0;
    bool m_following = false;
    bool m_fitted = true; ///< the whole plant is shown, and stays so when the widget is resized
    bool m_dragging = false;
    bool m_keyboardFocus = false; ///< the focus came by key, so its frame is shown
    QPointF m_press;
    QPointF m_last;
};

} // namespace agv::gui
