// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetricsF>
#include <QRectF>

#include "core/plant_layout.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

#include <vector>

class QPainter;

namespace agv::gui {

/// A station to scale: outline and a symbol of its kind, without its name.
void paintStation(QPainter& painter, const Viewport& viewport, const Station& station, const Theme& theme);

/// Where the names of the plant's stations stand, px, in their order: each inside its station or beside it,
/// where it lies on no other station, no other name and nothing of `taken` (px; AGVs, tags being read). One
/// that finds no such place in `visible` (px) stands where it would without them.
std::vector<QRectF> placeStationNames(const QFontMetricsF& metrics, const Viewport& viewport,
                                      const PlantLayout& plant, const QRectF& visible,
                                      const std::vector<QRectF>& taken);

void paintStationNames(QPainter& painter, const Viewport& viewport, const PlantLayout& plant,
                       const std::vector<QRectF>& places, const Theme& theme);

} // namespace agv::gui
