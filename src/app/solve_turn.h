// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/turn.h"

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace agv::app {

/// What `agv-console solve-turn` was asked for.
struct SolveTurnArguments {
    std::vector<std::string>
        files; ///< FILE...: turns, in any format of recording/turn_file.h; "-": standard input
    std::optional<std::string> plantFile; ///< --plant: tags, RSSI table and antenna
    std::optional<RobotId> robot;         ///< --robot: whose antenna of the plant file; empty: the first AGV
    std::optional<std::string> field;     ///< --field: "11x11", tags in columns x rows from the origin
    double pitch_mm = 100.0;              ///< --pitch: of --field, > 0
    SolveMethod method = SolveMethod::Auto; ///< --method
    std::optional<std::string> csvFile;     ///< --csv: empty: CSV on standard output, unless json
    bool json = false;                      ///< --json: JSON lines on standard output
    std::uint64_t seed = 1;                 ///< --seed of the solver
    double turnTime_ms = 1125.0;            ///< --turn-time: sleeptime, for files that do not say
    double step_deg = 45.0;                 ///< --step: nominal step, for files that do not say; 1 to 180
};

/// Solves every turn of every file, one per core at a time, and writes one row per turn to `out` (or the CSV
/// file) in the order of the files, "-" being `in`; the same input gives the same output but for elapsed_ms.
/// What cannot be read or solved is named on `err` as "FILE:LINE: reason" and never stops the others.
///
/// Without a plant file or a field, the tags are those of the emulator's side file beside FILE, or else the
/// seed's 3 x 3 test field if it has all tags of the file, or else the emulator's 11 x 11 field; which one is
/// said on `err`.
///
/// Returns the exit status: 0 all solved, 1 some turn or file failed, 2 wrong usage (then nothing is done).
int runSolveTurn(const SolveTurnArguments& arguments, std::istream& in, std::ostream& out, std::ostream& err);

} // namespace agv::app
