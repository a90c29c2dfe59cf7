// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/plant_layout.h"

#include <vector>

namespace agv::model {

/// The floor tags that people may mean by a text: a number, or where no tag has that number the digits of an
/// id, all of them or the last ones. Pointers into `plant`.
std::vector<const FloorTag*> floorTagsNamed(const QString& text, const PlantLayout& plant);

} // namespace agv::model
