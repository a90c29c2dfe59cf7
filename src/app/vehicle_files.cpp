// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/vehicle_files.h"

#include "app/uwb_files.h"
#include "core/plant_file.h"
#include "core/text_file.h"
#include "recording/floor_read_table.h"
#include "recording/odometry_table.h"

#include <algorithm>
#include <map>
#include <ostream>

namespace agv::app {

namespace {

using recording::FloorReadRow;
using recording::TagPlace;

constexpr std::size_t largestFile = std::size_t{64} << 20U;

/// Reads a file with one of the readers of recording/, naming what is wrong with its lines.
template<typename Read>
auto readTable(const std::string& path, std::ostream& err, bool& someBad, Read read)
    -> decltype(read(std::string_view()))
{
    const auto text = readTextStream(path, largestFile);
    if (!text)
        return std::unexpected(text.error());
    auto table = read(*text);
    if (!table)
        return std::unexpected(inFile(path, table.error()));
    report(path, table->problems, err);
    someBad = someBad || !table->problems.empty();
    return table;
}

/// Places of the floor tags: of --tags, or of the plant.
Result<std::vector<TagPlace>> tagPlaces(const LocateArguments& arguments, std::ostream& err, bool& someBad)
{
    if (arguments.tagsFile) {
        auto table = readTable(*arguments.tagsFile, err, someBad, recording::readTagPlaceCsv);
        if (!table)
            return std::unexpected(table.error());
        return std::move(table->tags);
    }
    if (!arguments.plantFile)
        return failure(ErrorCode::NotFound,
                       *arguments.floorFile + ": the places of the floor tags are not known; give --tags or "
                                              "--plant");
    const auto plant = readPlantFile(*arguments.plantFile);
    if (!plant)
        return std::unexpected(plant.error());
    std::vector<TagPlace> places;
    for (const FloorTag& tag : plant->floorTags)
        places.push_back({fullText(tag.uid), tag.position.x, tag.position.y});
    return places;
}

/// The tag that ends in these digits; nothing when there is none or more than one.
const TagPlace* findTag(const std::vector<TagPlace>& places, const std::string& uid)
{
    const TagPlace* found = nullptr;
    for (const TagPlace& place : places) {
        if (!place.uid.ends_with(uid) && !uid.ends_with(place.uid))
            continue;
        if (found != nullptr)
            return nullptr;
        found = &place;
    }
    return found;
}

/// The mean of the tags read at one time (thesis 4.1); nothing when none of them is known.
std::optional<Point2> meanOf(const FloorReadRow& row, const std::vector<TagPlace>& places,
                             std::map<std::string, std::size_t>& unknownTags)
{
    Point2 sum;
    int count = 0;
    for (const std::string& uid : row.uids) {
        if (const TagPlace* const place = findTag(places, uid)) {
            sum = sum + Point2{place->x_m, place->y_m};
            ++count;
        } else {
            ++unknownTags[uid];
        }
    }
    return count > 0 ? std::optional((1.0 / count) * sum) : std::nullopt;
}

Result<std::vector<FloorFix>> readFloorFixes(const LocateArguments& arguments, std::ostream& err,
                                             bool& someBad)
{
    const auto reads = readTable(*arguments.floorFile, err, someBad, recording::readFloorReadCsv);
    if (!reads)
        return std::unexpected(reads.error());
    std::vector<TagPlace> places;
    if (!reads->rows.front().x_m) {
        auto known = tagPlaces(arguments, err, someBad);
        if (!known)
            return std::unexpected(known.error());
        places = std::move(*known);
    }
    std::map<std::string, std::size_t> unknownTags;
    std::vector<FloorFix> fixes;
    for (const FloorReadRow& row : reads->rows) {
        if (row.x_m)
            fixes.push_back({row.time_s, {*row.x_m, *row.y_m}});
        else if (const auto mean = meanOf(row, places, unknownTags))
            fixes.push_back({row.time_s, *mean});
    }
    for (const auto& [uid, count] : unknownTags)
        err << *arguments.floorFile << ": tag " << uid << " is not one known tag; its " << count
            << " reads are left out\n";
    return fixes;
}

/// Distance of the wheels: as given, or of the plant's first AGV.
Result<std::optional<double>> wheelDistance(const LocateArguments& arguments)
{
    if (arguments.track_m || !arguments.plantFile)
        return arguments.track_m;
    const auto plant = readPlantFile(*arguments.plantFile);
    if (!plant)
        return std::unexpected(plant.error());
    return plant->agvs.empty() ? std::nullopt : std::optional(plant->agvs.front().track_m);
}

} // namespace

Result<VehicleData> readVehicleData(const LocateArguments& arguments, std::ostream& err, bool& someBad)
{
    VehicleData data;
    data.startHeading = arguments.startHeading;
    if (arguments.startPosition)
        data.startPose = Pose2{*arguments.startPosition, arguments.startHeading.value_or(0.0)};
    data.mount = arguments.mount;
    if (arguments.plantFile && !arguments.mount) {
        const auto plant = readPlantFile(*arguments.plantFile);
        if (!plant)
            return std::unexpected(plant.error());
        for (const UwbTag& tag : plant->uwb.tags)
            data.mounts[tag.id] = tag.mount;
    }
    if (arguments.odometryFile) {
        const auto distance_m = wheelDistance(arguments);
        if (!distance_m)
            return std::unexpected(distance_m.error());
        auto odometry = readTable(*arguments.odometryFile, err, someBad, [&](std::string_view text) {
            return recording::readOdometryCsv(text, *distance_m);
        });
        if (!odometry)
            return std::unexpected(odometry.error());
        data.odometry = std::move(odometry->rows);
        if (!arguments.startHeading)
            err << *arguments.odometryFile
                << ": --heading was not given; taking a vehicle that faces +x at first\n";
    }
    if (arguments.floorFile) {
        auto fixes = readFloorFixes(arguments, err, someBad);
        if (!fixes)
            return std::unexpected(fixes.error());
        data.floorFixes = std::move(*fixes);
    }
    return data;
}

} // namespace agv::app
