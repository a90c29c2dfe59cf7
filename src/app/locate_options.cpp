// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include "core/units.h"

#include <QFile>

#include <cmath>
#include <limits>

namespace agv::app {
namespace {

constexpr double farthest_m = 1000.0;
constexpr double farthestMount_mm = 2000.0; ///< as in plant files

std::optional<std::string> fileOption(const OptionReader& reader, const QString& name)
{
    const auto file = reader.text(name);
    return file ? std::optional(QFile::encodeName(*file).toStdString()) : std::nullopt;
}

std::optional<std::string> wordOption(const OptionReader& reader, const QString& name)
{
    const auto word = reader.text(name);
    return word ? std::optional(word->toStdString()) : std::nullopt;
}

void addCommonOptions(OptionReader& reader)
{
    reader.addPositional("INPUT",
                         "Files with ranges, or folders of them: range tables, DecaRangeRTLS logs, serial "
                         "captures; - is standard input.",
                         "INPUT...");
    reader.addValue("plant", "FILE", "Plant file with the anchors.");
    reader.addValue("anchors", "FILE", "Anchors: a table, or TREKanc_config.xml.");
    reader.addValue("height", "M", "Height of the tags above the floor; without it the truth's, or else 0.");
    reader.addFlag("3d", "Solve for the height, too.");
    reader.addValue("method", "NAME", "One of --list-methods, or all.");
    reader.addValue("calibrate", "RANGES:TRUTH",
                    "Learn the errors of the ranges from ranges taken at known places.");
    reader.addValue("truth", "FILE", "True places: print the errors.");
    reader.addValue("by", "COLUMN", "Errors for each value of a column of the ranges or the truth, or tag.");
    reader.addValue("csv", "FILE", "Write the positions there; without it and --truth to standard output.");
    reader.addValue("seed", "N", "Seed of particle filters; 1 without it.");
    reader.addFlag("list-methods", "Name every method with its source.");
}

LocateArguments readCommonOptions(OptionReader& reader)
{
    LocateArguments result;
    for (const QString& file : reader.positional())
        result.inputs.push_back(QFile::encodeName(file).toStdString());
    result.plantFile = fileOption(reader, "plant");
    result.anchorsFile = fileOption(reader, "anchors");
    result.height_m = reader.number("height", -farthest_m, farthest_m);
    result.inSpace = reader.isSet("3d");
    result.method = wordOption(reader, "method");
    result.calibrate = fileOption(reader, "calibrate");
    result.truthFile = fileOption(reader, "truth");
    result.by = wordOption(reader, "by");
    result.csvFile = fileOption(reader, "csv");
    result.seed = reader.integer("seed", 0, std::numeric_limits<std::uint64_t>::max()).value_or(1);
    result.listMethods = reader.isSet("list-methods");
    return result;
}

/// "X,Y", each from -farthest to farthest, in `unit`.
std::optional<Point2> pointOption(OptionReader& reader, const QString& name, double farthest,
                                  const char* unit)
{
    const auto text = reader.text(name);
    if (!text)
        return std::nullopt;
    const QStringList parts = text->split(',');
    bool isX = false;
    bool isY = false;
    const Point2 point{parts.value(0).toDouble(&isX), parts.value(1).toDouble(&isY)};
    const bool isPoint =
        parts.size() == 2 && isX && isY && std::abs(point.x) <= farthest && std::abs(point.y) <= farthest;
    reader.require(isPoint, QStringLiteral("--%1 is \"%2\": it must be X,Y in %3, each from -%4 to %4")
                                .arg(name, *text, unit)
                                .arg(farthest));
    return isPoint ? std::optional(point) : std::nullopt;
}

} // namespace

std::expected<LocateArguments, ParseExit> parseLocateArguments(const QStringList& arguments)
{
    OptionReader reader("agv-console locate",
                        "Positions of UWB tags from recorded ranges; with --truth, how good they are. Exit "
                        "status: 0 all was used, 1 some lines or files were not, 2 wrong usage.");
    addCommonOptions(reader);
    if (const auto exit = reader.parse(arguments))
        return std::unexpected(*exit);
    LocateArguments result = readCommonOptions(reader);
    reader.require(result.listMethods || !result.inputs.empty(), "no INPUT was given");
    if (const auto exit = reader.error())
        return std::unexpected(*exit);
    return result;
}

std::expected<LocateArguments, ParseExit> parseFuseArguments(const QStringList& arguments)
{
    OptionReader reader(
        "agv-console fuse",
        "Positions of a vehicle from recorded UWB ranges, wheel odometry and floor tags, or from floor tags "
        "without any INPUT; with "
        "--truth, how good they are. Exit status: 0 all was used, 1 some lines or files were "
        "not, 2 wrong usage.");
    addCommonOptions(reader);
    reader.addValue("odometry", "FILE",
                    "Wheel odometry: t_s,v_left_mps,v_right_mps or t_s,v_mps,omega_radps.");
    reader.addValue("wheel-distance", "M",
                    "Distance of the wheels; without it that of the plant's first AGV.");
    reader.addValue("heading", "DEG", "Heading at first, counter-clockwise from +x; 0 without it.");
    reader.addValue("start", "X,Y", "Position at first, m; without it that of the first ranges.");
    reader.addValue("rfid", "FILE", "Floor tags read: t_s and uid, uid1,uid2,..., or x_m,y_m.");
    reader.addValue(
        "mount", "X,Y",
        "Place of the UWB tag ahead and to the left of the vehicle's centre, mm; without it the plant's.");
    reader.addValue("tags", "FILE", "Places of the floor tags: uid,x_mm,y_mm; without it the plant's.");
    if (const auto exit = reader.parse(arguments))
        return std::unexpected(*exit);
    LocateArguments result = readCommonOptions(reader);
    result.fuse = true;
    result.odometryFile = fileOption(reader, "odometry");
    result.track_m = reader.number("wheel-distance", 0.01, 10.0);
    if (const auto heading = reader.number("heading", -360.0, 360.0))
        result.startHeading = radFromDeg(*heading);
    result.startPosition = pointOption(reader, "start", farthest_m, "metres");
    if (const auto mount = pointOption(reader, "mount", farthestMount_mm, "mm"))
        result.mount = Point2{metresFromMm(mount->x), metresFromMm(mount->y)};
    result.floorFile = fileOption(reader, "rfid");
    result.tagsFile = fileOption(reader, "tags");
    reader.require(result.listMethods || result.odometryFile || result.floorFile,
                   "fuse needs --odometry or --rfid; for ranges alone there is agv-console locate");
    reader.require(result.listMethods || result.floorFile || !result.inputs.empty(), "no INPUT was given");
    if (const auto exit = reader.error())
        return std::unexpected(*exit);
    return result;
}

} // namespace agv::app
