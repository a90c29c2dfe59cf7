// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/ids.h"
#include "core/serial_choice.h"
#include "core/uwb_unit.h"

#include <optional>
#include <string>
#include <vector>

namespace agv {

/// A UWB tag, on an AGV or not.
struct UwbTag {
    int id = 0;                 ///< 0..255, as in the reports
    std::string label;          ///< for people
    std::optional<RobotId> agv; ///< that carries it
    double z_m = 0.0;           ///< height of its antenna above the floor
    Point2 mount;               ///< its antenna in the vehicle frame, m; of a tag that an AGV carries
    friend bool operator==(const UwbTag&, const UwbTag&) = default;
};

/// What is added to the measured ranges between a tag and an anchor.
struct RangeCorrection {
    int anchor = 0;
    int tag = 0;
    double offset_m = 0.0;
    friend bool operator==(const RangeCorrection&, const RangeCorrection&) = default;
};

/// The UWB kit of a plant but for its anchors.
struct UwbSettings {
    SerialPortChoice port;             ///< where the unit is
    std::optional<UwbDialect> dialect; ///< how it writes; empty: found from what it writes
    double tagHeight_m = 0.3;          ///< of tags that the list does not name
    std::vector<UwbTag> tags;
    std::vector<RangeCorrection> corrections; ///< each pair of tag and anchor once; others: nothing is added
    friend bool operator==(const UwbSettings&, const UwbSettings&) = default;
};

} // namespace agv
