// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json_tree.h"
#include "core/plant_layout.h"

namespace agv {

/// The tree of a plant file with this layout. With an `original` (a tree that readPlant() accepted, or
/// nullptr) its order of keys, its unknown keys and its omitted defaults are kept.
Json plantTree(const PlantLayout& layout, const Json* original);

} // namespace agv
