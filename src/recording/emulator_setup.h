// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/plant_layout.h"
#include "core/result.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace agv::recording {

/// The side file that the seed's emulator writes beside its readings (appendix A, NumTags*.txt), five
/// numbers: tags, length of the plant in cm, start angle in rad, start position x and y in cm.
struct EmulatorSetup {
    int tags = 0;
    double length_m = 0.0;   ///< along x
    double startAngle = 0.0; ///< rad, centre to antenna at the first stop, as the emulator places it
    Point2 start;            ///< centre of the robot, m
    friend bool operator==(const EmulatorSetup&, const EmulatorSetup&) = default;
};

/// BadInput when it is not five numbers in their ranges.
Result<EmulatorSetup> parseEmulatorSetup(std::string_view text);

/// The side file of a file of readings: NumTags<n>.txt in the same folder, n being the digits at the end of
/// the name. Empty when there is none or it is not valid.
std::optional<EmulatorSetup> findEmulatorSetup(const std::filesystem::path& readings);

/// The emulator's field: tags in a grid from the origin at a pitch of 100 mm (its d1), numbered column by
/// column. The side file does not say the pitch; empty when its numbers do not fit to 100 mm.
std::optional<std::vector<FloorTag>> fieldOf(const EmulatorSetup& setup, TagUid firstUid);

} // namespace agv::recording
