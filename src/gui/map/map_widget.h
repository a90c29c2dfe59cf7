// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "gui/map/map_layers.h"
#include "gui/map/measure_line.h"
#include "gui/map/minimap.h"
#include "gui/map/static_layer.h"
#include "gui/map/trails.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"
#include "model/floor_tag_states.h"

namespace agv::gui {

/// What a press and drag with the left button does.
enum class MapTool {
    Select,      ///< a click chooses, a drag moves the picture
    Measure,     ///< from point to point, on things near the pointer exactly
    MoveAnchors, ///< drags a UWB anchor to another place; elsewhere as Select
};

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

    /// The map as it is shown now, for a picture of the widget's size.
    void paintPicture(QPainter& painter);

    const Viewport& viewport() const { return m_viewport; }
    int staticPaintCount() const { return m_static.paintCount(); }
    int framePaintCount() const { return m_frames; }
    const MapLayers& layers() const { return m_static.layers(); }
    void setLayers(const MapLayers& layers);
    const TrailLimit& trailLimit() const { return m_trails.limit(); }
    void setTrailLimit(const TrailLimit& limit);

    MapTool tool() const { return m_tool; }
    void setTool(MapTool tool);
    const std::optional<MeasureLine>& measured() const { return m_measured; }
    /// Measures from `from` on, m; the next press sets the other end.
    void measureFrom(Point2 from);
    /// The place of the floor tag, anchor or station within reach of `pixel`, else the point under it.
    Point2 snapped(QPointF pixel) const;
    /// The UWB tag whose ranges are shown: the one clicked last, else the one on the chosen AGV; null: none.
    const UwbTagSnapshot* shownUwbTag() const;

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
    void centreOn(agv::Point2 place);
    /// Centred, and large enough to tell a floor tag from its neighbours.
    void showPlace(agv::Point2 place);
    void setFollowing(bool following);

signals:
    void robotClicked(int robot);
    /// An anchor was dragged; the owner of the list answers with setUwbAnchors().
    void anchorMoved(int id, agv::Point2 place);
    /// The operator wants the menu of the map at `position` (global), about the plant point `place`.
    void menuRequested(QPoint position, agv::Point2 place);
    void toolChanged(agv::gui::MapTool tool);
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
    void contextMenuEvent(QContextMenuEvent* event) override;
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
    const UwbTagSnapshot* uwbTagAt(QPointF pixel) const;
    const UwbAnchor* anchorAt(QPointF pixel) const;
    void pressMeasure(QPointF pixel);
    void click(QPointF pixel);
    void setToolCursor();
    QString agvDetails(const AgvSnapshot& agv) const;
    QString stopDetails(QPointF pixel) const;
    const FloorTag* floorTagAt(QPointF pixel) const;
    QString tagDetails(QPointF pixel) const;
    QString unknownTagDetails(QPointF pixel) const;
    QString accuracyDetails(QPointF pixel) const;
    QString uwbTagDetails(QPointF pixel) const;
    QString anchorDetails(QPointF pixel) const;
    QString stationDetails(QPointF pixel) const;
    void paintReads(QPainter& painter) const;
    void paintAgvs(QPainter& painter) const;
    void paintAbove(QPainter& painter) const; ///< everything over the static layer
    void paintMoving(QPainter& painter) const;
    void paintOverlays(QPainter& painter) const;

    PlantLayout m_plant;
    TagMap m_tags;
    PlantSnapshot m_snapshot;
    Trails m_trails;
    model::FloorTagStates m_tagStates;
    Minimap m_minimap;
    StaticLayer m_static;
    Viewport m_viewport;
    Theme m_theme = Theme::light();
    int m_selected = 0;
    int m_frames = 0;
    bool m_following = false;
    bool m_fitted = true; ///< the whole plant is shown, and stays so when the widget is resized
    bool m_dragging = false;
    MapTool m_tool = MapTool::Select;
    std::optional<MeasureLine> m_measured;
    bool m_measuring = false;          ///< the line's end still follows the pointer
    std::optional<int> m_clickedTag;   ///< UWB tag
    std::optional<int> m_movingAnchor; ///< while it is dragged
    Point2 m_movedTo;                  ///< where the dragged anchor is now, m
    bool m_keyboardFocus = false;      ///< the focus came by key, so its frame is shown
    QPointF m_press;
    QPointF m_last;
};

} // namespace agv::gui
