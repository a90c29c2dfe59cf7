// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QImage>

#include "core/plant_layout.h"
#include "gui/map/map_layers.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

class QPainter;

namespace agv::gui {

/// Widths of the rulers along the left and the lower edge of the map, px.
inline constexpr double rulerWidth = 52.0;
inline constexpr double rulerHeight = 24.0;
/// Width of the lower right corner that the scale bar may take, px.
inline constexpr double scaleBarRoom = 132.0;

/// Everything of the map that does not move: floor, grid, floor tags, stations, obstacles, UWB anchors, plant
/// edge,
/// rulers, scale bar. Painted into an image once per view and reused until view, plant or colours change.
class StaticLayer {
public:
    void setPlant(const PlantLayout* plant); ///< not owned; must outlive the layer
    void setTheme(const Theme& theme);
    void setFont(const QFont& font);
    void setLayers(const MapLayers& layers);
    const MapLayers& layers() const { return m_layers; }

    /// The picture of `viewport` at this device pixel ratio.
    const QImage& image(const Viewport& viewport, double devicePixelRatio);

    /// Paints the same with another painter, for a drawing or a document.
    void paintAt(QPainter& painter, const Viewport& viewport);

    /// How often the picture has been painted anew; snapshots must not raise it.
    int paintCount() const { return m_paintCount; }

private:
    void paint(QPainter& painter) const;
    void paintFloor(QPainter& painter) const;
    void paintFloorTags(QPainter& painter) const;
    void paintStations(QPainter& painter) const;
    void paintObstacles(QPainter& painter) const;
    void paintRulers(QPainter& painter) const;
    void paintScaleBar(QPainter& painter) const;

    const PlantLayout* m_plant = nullptr;
    Theme m_theme = Theme::light();
    QFont m_font;
    MapLayers m_layers;
    Viewport m_viewport;
    double m_ratio = 0.0;
    bool m_valid = false;
    QImage m_image;
    int m_paintCount = 0;
};

/// The plant's rectangle in m (QRectF::bottom() is the northern edge), widened to hold every floor tag and
/// every anchor that is shown.
QRectF areaOf(const PlantLayout& plant);

} // namespace agv::gui
