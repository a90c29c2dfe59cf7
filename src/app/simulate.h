// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/uwb_unit.h"
#include "simulation/emulator_file.h"

#include <cstdint>
#include <optional>
#include <string>

namespace agv::app {

/// What `agv-console simulate` was asked for.
struct SimulateArguments {
    std::optional<std::string> plantFile;       ///< --plant; empty: the built-in plant
    bool smallField = false;                    ///< --small-field: the built-in 3 x 3 field instead
    std::uint64_t seed = 1;                     ///< --seed
    std::optional<Endpoint> console;            ///< --console; empty: the plant file's listen address
    std::optional<std::uint16_t> telemetryPort; ///< --telemetry-port; empty: the plant file's
    bool fixedReaderPorts = false;              ///< --reader-ports fixed
    std::optional<double> batteryPercent;       ///< --battery, 0..100; empty: drawn per AGV
    std::optional<std::string> uwbLink;         ///< --uwb-link: path of a symbolic link to the UWB port
    UwbDialect uwbDialect = UwbDialect::Trek;   ///< --uwb-dialect
    bool uwbSlow = false;                       ///< --uwb-slow: 3.57 reports a second and tag, else 10
    std::optional<std::string> truthLog;        ///< --truth-log: CSV of true poses
    std::optional<std::string> controlSocket; ///< --control: path of a local socket that takes commands, too
    bool parentGuard = false; ///< --parent-guard: end with standard input, whatever it is; a pipe always does

    /// --emulator-file DIR: write the files of the seed's emulator there and end.
    std::optional<std::string> emulatorFolder;
    simulation::EmulatorOptions emulator;
};

/// Runs the simulated plant until `quit` or the end of standard input: one JSON line on standard output when
/// ready, then one per command or event; messages for people on standard error. Makes the application object
/// when there is none. Returns the exit status: 0, or 1 when it could not do what it was asked for.
int runSimulate(const SimulateArguments& arguments);

} // namespace agv::app
