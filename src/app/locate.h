// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace agv::app {

/// What `agv-console locate` or `agv-console fuse` was asked for.
struct LocateArguments {
    bool fuse = false;               ///< the subcommand is fuse: methods that use more than ranges
    std::vector<std::string> inputs; ///< INPUT...: files of recording/range_file.h, folders of them; "-":
                                     ///< standard input. fuse may have none: floor tags (and wheels) alone
    std::optional<std::string> plantFile;   ///< --plant
    std::optional<std::string> anchorsFile; ///< --anchors
    std::optional<double> height_m;         ///< --height of the tags; empty: the truth's, or else 0
    bool inSpace = false;                   ///< --3d: the height is solved for, too
    std::optional<std::string> method;      ///< --method; "all"; empty: the default
    std::optional<std::string> calibrate;   ///< --calibrate "RANGES:TRUTH"
    std::optional<std::string> truthFile;   ///< --truth
    std::optional<std::string> by;          ///< --by: a row for each value of this column
    std::optional<std::string> csvFile;     ///< --csv
    std::uint64_t seed = 1;                 ///< --seed of particle filters
    bool listMethods = false;               ///< --list-methods

    // fuse
    std::optional<std::string> odometryFile; ///< --odometry
    std::optional<double> track_m;           ///< --wheel-distance, > 0; empty: of the plant's first AGV
    std::optional<std::string> floorFile;    ///< --rfid: floor tags read, or positions from them
    std::optional<std::string> tagsFile;     ///< --tags: places of floor tags; empty: the plant's
    std::optional<double> startHeading;      ///< --heading, rad
    std::optional<Point2> startPosition;     ///< --start, m; needs startHeading
    std::optional<Point2>
        mount; ///< --mount of the UWB tag in the vehicle frame, m; empty: the plant's, or else 0
};

/// Positions of UWB tags from recorded ranges. Without a truth file each position goes to `out` (or the CSV
/// file) as CSV; with one, and with a CSV file, `out` gets a table with the errors of every file and method.
/// The same input gives the same output. What cannot be read is named on `err` as "FILE:LINE: reason" and
/// never stops the other lines and files.
///
/// Returns the exit status: 0, 1 some line or file could not be used or has no position at all, 2 wrong usage
/// (then nothing is done).
int runLocate(const LocateArguments& arguments, std::istream& in, std::ostream& out, std::ostream& err);

} // namespace agv::app
