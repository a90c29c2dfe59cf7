// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include "app/locate.h"
#include "app/option_reader.h"
#include "app/plant_command.h"
#include "app/simulate.h"
#include "app/solve_turn.h"
#include "app/trainer.h"
#include "core/turn.h"

#include <cstdint>
#include <expected>
#include <optional>
#include <string>

namespace agv::app {

/// Which plant, and whether it is a simulated one.
struct PlantChoice {
    std::optional<std::string> plantFile;     ///< --plant; empty: a built-in one
    bool smallField = false;                  ///< --small-field
    bool simulate = false;                    ///< --simulate
    std::uint64_t seed = 1;                   ///< --seed: of the simulation and the solver
    std::optional<double> batteryPercent;     ///< --battery, 0..100: of every simulated AGV
    std::optional<std::string> controlSocket; ///< --control: where a trainer steers the simulated plant
};

struct WindowArguments {
    PlantChoice plant;
};

struct CalibrateArguments {
    PlantChoice plant;
    std::optional<int> robot; ///< --robot; empty: all, one after the other
    TurnParameters turn;      ///< the sleeptime and the speed are the plant file's unless given
    bool turnTimeGiven = false;
    bool speedGiven = false;
    SolveMethod method = SolveMethod::Auto;
    std::optional<std::string> outFolder;
};

// Each reads the arguments behind the program's name and subcommand.
std::expected<WindowArguments, ParseExit> parseWindowArguments(const QStringList& arguments);
std::expected<CalibrateArguments, ParseExit> parseCalibrateArguments(const QStringList& arguments);
std::expected<SimulateArguments, ParseExit> parseSimulateArguments(const QStringList& arguments);
std::expected<TrainerArguments, ParseExit> parseTrainerArguments(const QStringList& arguments);
std::expected<SolveTurnArguments, ParseExit> parseSolveTurnArguments(const QStringList& arguments);
std::expected<LocateArguments, ParseExit> parseLocateArguments(const QStringList& arguments);
std::expected<LocateArguments, ParseExit> parseFuseArguments(const QStringList& arguments);
std::expected<PlantArguments, ParseExit> parsePlantArguments(const QStringList& arguments);
/// has-display takes none; empty: go on.
std::optional<ParseExit> parseHasDisplayArguments(const QStringList& arguments);

} // namespace agv::app
