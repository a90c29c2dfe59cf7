// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line.h"
#include "core/plant_layout.h"
#include "core/result.h"

#include <string>
#include <vector>

namespace agv::app {

struct LoadedPlant {
    PlantLayout layout;
    std::vector<std::string> warnings; ///< about the plant file, for the operator
};

/// The plant file that was asked for, or a built-in one.
Result<LoadedPlant> loadPlant(const PlantChoice& choice);

} // namespace agv::app
