// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include "core/units.h"

#include <QFile>

#include <algorithm>
#include <array>
#include <limits>

namespace agv::app {
namespace {

constexpr std::uint64_t largestSeed = std::numeric_limits<std::uint64_t>::max();

void addPlantOptions(OptionReader& reader)
{
    reader.addValue("plant", "FILE", "Plant file to use; without it the built-in plant.");
    reader.addFlag("small-field", "Use the built-in field of 3 x 3 tags.");
    reader.addValue("seed", "N", "Makes a simulation and the solver repeatable; 1 without it.");
    reader.addValue("battery", "PERCENT", "Charge of the simulated batteries; without it each has its own.");
    reader.addValue("control", "PATH",
                    "Local socket where \"agv-console trainer\" steers the simulated plant.");
}

PlantChoice readPlantOptions(OptionReader& reader)
{
    PlantChoice choice;
    if (const auto file = reader.text("plant"))
        choice.plantFile = file->toStdString();
    choice.smallField = reader.isSet("small-field");
    choice.seed = reader.integer("seed", 0, largestSeed).value_or(1);
    choice.batteryPercent = reader.number("battery", 0.0, 100.0);
    if (const auto path = reader.text("control"))
        choice.controlSocket = QFile::encodeName(*path).toStdString();
    reader.require(!(choice.plantFile && choice.smallField), "--plant and --small-field exclude each other");
    return choice;
}

void addSimulateFlag(OptionReader& reader)
{
    reader.addFlag("simulate", "Start a simulated plant beside the console and use it.");
}

void readSimulateFlag(OptionReader& reader, PlantChoice& choice)
{
    choice.simulate = reader.isSet("simulate");
    reader.require(choice.simulate || !choice.batteryPercent, "--battery needs --simulate");
    reader.require(choice.simulate || !choice.controlSocket, "--control needs --simulate");
}

void readTurn(OptionReader& reader, CalibrateArguments& arguments)
{
    reader.require(!(reader.isSet("timed") && reader.isSet("measured")),
                   "--timed and --measured exclude each other");
    if (reader.isSet("measured"))
        arguments.turn.kind = TurnKind::Measured;
    if (reader.isSet("clockwise"))
        arguments.turn.rotation = Rotation::Clockwise;
    if (const auto stops = reader.choice("stops", {"8", "12", "16"}))
        arguments.turn.stopsPerTurn = stops->toInt();
    if (const auto time_ms = reader.number("turn-time", leastSleeptime_ms, mostSleeptime_ms)) {
        arguments.turn.turnTime_s = *time_ms * 1e-3;
        arguments.turnTimeGiven = true;
    }
    if (const auto speed_mm_s =
            reader.number("speed", mmFromMetres(leastTurnSpeed), mmFromMetres(mostTurnSpeed))) {
        arguments.turn.wheelSpeed_m_s = metresFromMm(*speed_mm_s);
        arguments.speedGiven = true;
    }
    if (const auto dwell_s = reader.number("dwell", arguments.turn.minDwell_s, mostDwell_s))
        arguments.turn.maxDwell_s = *dwell_s;
}

SolveMethod methodFrom(const QString& word)
{
    if (word == "fast")
        return SolveMethod::Fast;
    return word == "classic" ? SolveMethod::Classic : SolveMethod::Auto;
}

std::optional<Endpoint> endpointOf(OptionReader& reader, const QString& name)
{
    const auto text = reader.text(name);
    if (!text)
        return std::nullopt;
    const Result<Endpoint> endpoint = parseEndpoint(text->toStdString());
    reader.require(endpoint.has_value(),
                   "--" + name + ": " +
                       (endpoint ? QString() : QString::fromStdString(endpoint.error().detail)));
    return endpoint ? std::optional(*endpoint) : std::nullopt;
}

void addEmulatorOptions(OptionReader& reader)
{
    reader.addValue("emulator-file", "DIR", "Write the files of the seed's emulator into DIR and end.");
    reader.addFlag("reader-like", "Emulator file: lines as the reader prints them.");
    reader.addFlag("changes-only", "Emulator file: only readings that changed since the last stop.");
    reader.addFlag("hexadecimal", "Emulator file: tag numbers as 16 hexadecimal digits.");
    reader.addValue("field", "COLUMNSxROWS", "Emulator file: size of the field of tags; 11x11 without it.");
    reader.addValue("x", "MM", "Emulator file: centre of the robot.");
    reader.addValue("y", "MM", "Emulator file: centre of the robot.");
    reader.addValue("bearing", "DEG", "Emulator file: direction from centre to antenna at the first stop.");
    reader.addValue("step", "DEG", "Emulator file: angle between stops, counter-clockwise.");
    reader.addValue("stops", "N", "Emulator file: readings, the closing one included.");
    reader.addValue("number", "N", "Emulator file: number in the names of the files; 11 without it.");
}

/// Options that a simulation on sockets would leave unread.
constexpr std::array emulatorOptions{"reader-like", "changes-only", "hexadecimal", "field", "x",
                                     "y",           "bearing",      "step",        "stops", "number"};

simulation::EmulatorOptions readEmulatorOptions(OptionReader& reader)
{
    for (const char* option : emulatorOptions)
        reader.require(reader.isSet("emulator-file") || !reader.isSet(option),
                       QStringLiteral("--%1 needs --emulator-file").arg(option));
    constexpr double widest_mm = 1e5;
    simulation::EmulatorOptions options;
    options.readerLike = reader.isSet("reader-like");
    options.changesOnly = reader.isSet("changes-only");
    options.hexadecimal = reader.isSet("hexadecimal");
    if (const auto field = reader.text("field")) {
        const QStringList parts = field->split('x');
        options.columns = parts.value(0).toInt();
        options.rows = parts.value(1).toInt();
        reader.require(parts.size() == 2 && options.columns > 0 && options.rows > 0,
                       "--field is \"" + *field + "\": it must look like 11x11");
    }
    if (const auto x = reader.number("x", -widest_mm, widest_mm))
        options.centre.x = metresFromMm(*x);
    if (const auto y = reader.number("y", -widest_mm, widest_mm))
        options.centre.y = metresFromMm(*y);
    if (const auto bearing = reader.number("bearing", -360.0, 360.0))
        options.bearing = radFromDeg(*bearing);
    if (const auto step = reader.number("step", -360.0, 360.0))
        options.step = radFromDeg(*step);
    if (const auto stops = reader.integer("stops", 1, 360))
        options.stops = static_cast<int>(*stops);
    if (const auto number = reader.integer("number", 0, 999'999))
        options.fileNumber = static_cast<int>(*number);
    return options;
}

} // namespace

std::expected<WindowArguments, ParseExit> parseWindowArguments(const QStringList& arguments)
{
    OptionReader reader(
        "agv-console",
        "Operator console for the AGVs of a pipeless plant.\n\n"
        "  agv-console [options]              the window\n"
        "  agv-console calibrate [options]    initialisation turns without a window\n"
        "  agv-console solve-turn FILE...     solves recorded turns\n"
        "  agv-console simulate [options]     a simulated plant on real sockets\n"
        "  agv-console plant ACTION FILE...   checks a plant file, imports and exports its tags\n"
        "  agv-console trainer COMMAND        breaks or moves things in a simulated plant\n"
        "  agv-console has-display            says whether the window can be shown\n"
        "Each has its own --help.");
    addPlantOptions(reader);
    addSimulateFlag(reader);
    if (const auto exit = reader.parse(arguments))
        return std::unexpected(*exit);
    WindowArguments result;
    result.plant = readPlantOptions(reader);
    readSimulateFlag(reader, result.plant);
    reader.forbidPositional();
    if (const auto exit = reader.error())
        return std::unexpected(*exit);
    return result;
}

std::expected<CalibrateArguments, ParseExit> parseCalibrateArguments(const QStringList& arguments)
{
    OptionReader reader(
        "agv-console calibrate",
        "Turns AGVs on the spot, reads the floor tags and says where they stand. Exit status: 0 "
        "every turn gave a pose, 1 one did not, 2 wrong usage, 130 or 143 ended by a signal.");
    addPlantOptions(reader);
    addSimulateFlag(reader);
    reader.addValue("robot", "N", "Number of the AGV; without it all, one after the other.");
    reader.addFlag("timed", "Steps end after the sleeptime (this is the rule).");
    reader.addFlag("measured", "Steps end when the robot's wheel encoders say so.");
    reader.addFlag("clockwise", "Turn clockwise.");
    reader.addValue("stops", "N", "Stops of a turn: 8, 12 or 16; a closing one is added. 8 without it.");
    reader.addValue("turn-time", "MS", "Sleeptime: time of a 45 degree turn; without it the plant file's.");
    reader.addValue(
        "speed", "MM_S",
        "Wheel speed while turning, 10 to 250; without it the plant file's. Without --turn-time the "
        "plant file's sleeptime is scaled to it.");
    reader.addValue("dwell", "S", "Longest time at a stop, 0.3 to 10; 2 without it.");
    reader.addValue("method", "NAME", "Solver: auto, fast or classic; auto without it.");
    reader.addValue("out", "DIR",
                    "Folder for results and captures; made when missing. Needed without --simulate.");
    if (const auto exit = reader.parse(arguments))
        return std::unexpected(*exit);
    CalibrateArguments result;
    result.plant = readPlantOptions(reader);
    readSimulateFlag(reader, result.plant);
    if (const auto robot = reader.integer("robot", 1, 1'000'000))
        result.robot = static_cast<int>(*robot);
    readTurn(reader, result);
    if (const auto method = reader.choice("method", {"auto", "fast", "classic"}))
        result.method = methodFrom(*method);
    if (const auto folder = reader.text("out"))
        result.outFolder = folder->toStdString();
    reader.require(!result.outFolder || !result.outFolder->empty(), "--out needs a folder");
    reader.require(result.outFolder || result.plant.simulate, "--out DIR is missing");
    reader.forbidPositional();
    if (const auto exit = reader.error())
        return std::unexpected(*exit);
    return result;
}

namespace {

/// All but "unknown".
QStringList uwbDialectNames()
{
    QStringList names;
    for (std::size_t i = 1; i < uwbDialectCount; ++i)
        names << QString::fromLatin1(toText(static_cast<UwbDialect>(i)));
    return names;
}

} // namespace

std::expected<SimulateArguments, ParseExit> parseSimulateArguments(const QStringList& arguments)
{
    OptionReader reader(
        "agv-console simulate",
        "A simulated plant on real sockets. Prints one JSON line when it is ready and one per "
        "command or event; reads commands from standard input (\"help\" lists them).");
    addPlantOptions(reader);
    reader.addValue("console", "HOST:PORT", "Where the robots connect; without it the plant file's address.");
    reader.addValue("telemetry-port", "PORT", "UDP port of the console; without it the plant file's.");
    reader.addValue("reader-ports", "KIND", "fixed: those of the plant file; free: any (this is the rule).");
    reader.addValue("uwb-link", "PATH", "Symbolic link to the serial device of the UWB kit.");
    reader.addValue("uwb-dialect", "NAME", "How the UWB kit writes: " + uwbDialectNames().join(", ") + ".");
    reader.addFlag("uwb-slow", "UWB at 110 kb/s: 3.57 reports a second and tag instead of 10.");
    reader.addValue("truth-log", "FILE", "Write the true poses as CSV.");
    reader.addFlag("parent-guard", "End with standard input, whatever it is.");
    addEmulatorOptions(reader);
    if (const auto exit = reader.parse(arguments))
        return std::unexpected(*exit);
    const PlantChoice plant = readPlantOptions(reader);
    SimulateArguments result;
    result.plantFile = plant.plantFile;
    result.smallField = plant.smallField;
    result.seed = plant.seed;
    result.batteryPercent = plant.batteryPercent;
    result.controlSocket = plant.controlSocket;
    result.console = endpointOf(reader, "console");
    if (const auto port = reader.integer("telemetry-port", 1, 65535))
        result.telemetryPort = static_cast<std::uint16_t>(*port);
    result.fixedReaderPorts = reader.choice("reader-ports", {"fixed", "free"}) == "fixed";
    if (const auto link = reader.text("uwb-link"))
        result.uwbLink = link->toStdString();
    if (const auto dialect = reader.choice("uwb-dialect", uwbDialectNames()))
        result.uwbDialect = parseUwbDialect(dialect->toStdString()).value_or(UwbDialect::Trek);
    result.uwbSlow = reader.isSet("uwb-slow");
    if (const auto file = reader.text("truth-log"))
        result.truthLog = file->toStdString();
    result.parentGuard = reader.isSet("parent-guard");
    if (const auto folder = reader.text("emulator-file"))
        result.emulatorFolder = folder->toStdString();
    result.emulator = readEmulatorOptions(reader);
    reader.forbidPositional();
    if (const auto exit = reader.error())
        return std::unexpected(*exit);
    return result;
}

std::expected<TrainerArguments, ParseExit> parseTrainerArguments(const QStringList& arguments)
{
    OptionReader reader("agv-console trainer",
                        "Sends a command to a running simulated plant and prints its answer; \"help\" lists "
                        "the commands. Exit status: 0 done, 1 refused or not reached, 2 wrong usage.");
    reader.addValue("control", "PATH", "The socket of the simulated plant, as given there. Needed.");
    reader.addPositional("COMMAND", "As \"cut reader 1 5\"; without it one a line on standard input.",
                         "[COMMAND...]");
    reader.keepWhatFollows();
    if (const auto exit = reader.parse(arguments))
        return std::unexpected(*exit);
    TrainerArguments result;
    if (const auto path = reader.text("control"))
        result.socketPath = QFile::encodeName(*path).toStdString();
    result.command = reader.positional().join(' ').toStdString();
    reader.require(!result.socketPath.empty(), "--control PATH is missing");
    if (const auto exit = reader.error())
        return std::unexpected(*exit);
    return result;
}

std::expected<SolveTurnArguments, ParseExit> parseSolveTurnArguments(const QStringList& arguments)
{
    OptionReader reader(
        "agv-console solve-turn",
        "Solves recorded turns: JSON lines, emulator files, raw captures, tables of stops. One row "
        "of CSV per turn on standard output. Exit status: 0 all solved, 1 some not, 2 wrong usage.");
    reader.addPositional("FILE", "Files with turns, in any of the formats; - is standard input.", "FILE...");
    reader.addValue("plant", "FILE", "Plant file with tags, RSSI table and antenna.");
    reader.addValue("robot", "N", "Whose antenna of the plant file; the first AGV's without it.");
    reader.addValue("field", "COLUMNSxROWS",
                    "Instead of a plant file: a grid of tags from the origin, as 11x11.");
    reader.addValue("pitch", "MM", "Distance of the tags of --field; 100 without it.");
    reader.addValue("method", "NAME", "Solver: auto, fast or classic; auto without it.");
    reader.addValue("csv", "FILE", "Write the CSV there.");
    reader.addFlag("json", "JSON lines on standard output.");
    reader.addValue("seed", "N", "Seed of the solver; 1 without it.");
    reader.addValue("turn-time", "MS", "Sleeptime, for files that do not say; 1125 without it.");
    reader.addValue("step", "DEG", "Nominal step, for files that do not say; 45 without it.");
    if (const auto exit = reader.parse(arguments))
        return std::unexpected(*exit);
    SolveTurnArguments result;
    for (const QString& file : reader.positional())
        result.files.push_back(QFile::encodeName(file).toStdString());
    if (const auto file = reader.text("plant"))
        result.plantFile = QFile::encodeName(*file).toStdString();
    if (const auto robot = reader.integer("robot", 1, 1'000'000))
        result.robot = RobotId{static_cast<int>(*robot)};
    if (const auto field = reader.text("field"))
        result.field = field->toStdString();
    result.pitch_mm = reader.number("pitch", 1.0, 1e4).value_or(result.pitch_mm);
    if (const auto method = reader.choice("method", {"auto", "fast", "classic"}))
        result.method = methodFrom(*method);
    if (const auto file = reader.text("csv"))
        result.csvFile = QFile::encodeName(*file).toStdString();
    result.json = reader.isSet("json");
    result.seed = reader.integer("seed", 0, largestSeed).value_or(1);
    result.turnTime_ms =
        reader.number("turn-time", leastSleeptime_ms, mostSleeptime_ms).value_or(result.turnTime_ms);
    result.step_deg = reader.number("step", 1.0, 180.0).value_or(result.step_deg);
    reader.require(!result.files.empty(), "no FILE was given");
    reader.require(!(result.plantFile && result.field), "--plant and --field exclude each other");
    if (const auto exit = reader.error())
        return std::unexpected(*exit);
    return result;
}

std::expected<PlantArguments, ParseExit> parsePlantArguments(const QStringList& arguments)
{
    OptionReader reader("agv-console plant",
                        "Works on plant files.\n\n"
                        "  check PLANT...           says what is wrong, and where\n"
                        "  export-tags PLANT        writes the floor tags as a table (CSV)\n"
                        "  import-tags PLANT CSV    takes surveyed tags over; the rest of the file stays\n\n"
                        "Exit status: 0 all was well, 1 it was not and nothing changed, 2 wrong usage.");
    reader.addPositional("ACTION", "check, export-tags or import-tags.", "ACTION");
    reader.addPositional("FILE", "Plant file, and the table to import.", "FILE...");
    reader.addValue("out", "FILE",
                    "Write there: the table instead of standard output, the plant instead of itself.");
    reader.addFlag("merge", "Import: tags that the table does not have stay.");
    if (const auto exit = reader.parse(arguments))
        return std::unexpected(*exit);
    const QStringList actions{"check", "export-tags", "import-tags"};
    const QStringList words = reader.positional();
    PlantArguments result;
    result.action = static_cast<PlantAction>(std::max(actions.indexOf(words.value(0)), qsizetype{0}));
    for (const QString& file : words.mid(1))
        result.plantFiles.push_back(QFile::encodeName(file).toStdString());
    if (const auto file = reader.text("out"))
        result.outFile = QFile::encodeName(*file).toStdString();
    result.merge = reader.isSet("merge");
    const bool imports = result.action == PlantAction::ImportTags;
    const std::size_t count = result.plantFiles.size();
    reader.require(actions.contains(words.value(0)), "ACTION must be one of " + actions.join(", "));
    reader.require(!imports || count == 2, "import-tags needs a plant file and a table");
    reader.require(result.action != PlantAction::ExportTags || count == 1,
                   "export-tags needs one plant file");
    reader.require(count > 0, "no FILE was given");
    reader.require(!result.merge || imports, "--merge belongs to import-tags");
    reader.require(!result.outFile || result.action != PlantAction::Check, "check writes nothing to --out");
    if (const auto exit = reader.error())
        return std::unexpected(*exit);
    if (imports) {
        result.csvFile = result.plantFiles.back();
        result.plantFiles.pop_back();
    }
    return result;
}

std::optional<ParseExit> parseHasDisplayArguments(const QStringList& arguments)
{
    OptionReader reader("agv-console has-display",
                        "For scripts: says whether the window can be shown. Exit status: 0 it can, 1 it "
                        "cannot, and why in one line on standard error, 2 wrong usage.");
    if (const auto exit = reader.parse(arguments))
        return exit;
    reader.forbidPositional();
    return reader.error();
}

} // namespace agv::app
