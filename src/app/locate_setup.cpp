// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/locate_setup.h"

#include "app/locate_output.h"
#include "app/uwb_truth.h"
#include "app/vehicle_files.h"
#include "core/text_file.h"
#include "estimation/uwb/locator.h"

#include <cmath>
#include <ostream>

namespace agv::app {

namespace {

using estimation::MethodInfo;
using estimation::MethodInput;

constexpr std::string_view everyMethod = "all";
constexpr std::string_view defaultInSpace = "gauss-newton-3d";
constexpr std::string_view defaultWithWheels = "fusion";
constexpr std::string_view defaultWithoutWheels = "fusion-position";

bool needsWheels(std::string_view method) { return method == defaultWithWheels; }
bool needsFloorTags(std::string_view method) { return method == "rfid-average"; }
bool needsRanges(const MethodInfo& method)
{
    return method.input == MethodInput::Ranges || method.name == "fusion-particle";
}

std::string namesOf(const LocateArguments& arguments)
{
    std::string names;
    for (const MethodInfo& method : estimation::allMethods())
        if (method.input == MethodInput::Ranges || (arguments.fuse && method.input == MethodInput::Fusion))
            names += (names.empty() ? "" : ", ") + std::string(method.name);
    return names;
}

std::optional<std::string> whyMethodIsWrong(const LocateArguments& arguments)
{
    if (!arguments.method || *arguments.method == everyMethod)
        return std::nullopt;
    if (*arguments.method == automaticMethod && arguments.inputs.empty())
        return "method auto needs ranges; name an INPUT";
    if (*arguments.method == automaticMethod)
        return arguments.inSpace ? std::optional("method auto does not solve for the height, as --3d asks")
                                 : std::nullopt;
    const MethodInfo* const method = estimation::findMethod(*arguments.method);
    if (method == nullptr)
        return "there is no method \"" + *arguments.method + "\"; take auto, all or one of " +
               namesOf(arguments);
    if (method->input == MethodInput::Special)
        return "method " + *arguments.method + " does not run on ranges: " + std::string(method->title);
    if (method->input == MethodInput::Fusion && !arguments.fuse)
        return "method " + *arguments.method + " belongs to agv-console fuse";
    if (needsRanges(*method) && arguments.inputs.empty())
        return "method " + *arguments.method + " needs ranges; name an INPUT";
    if (needsWheels(*arguments.method) && !arguments.odometryFile)
        return "method " + *arguments.method + " needs --odometry";
    if (needsFloorTags(*arguments.method) && !arguments.floorFile)
        return "method " + *arguments.method + " needs --rfid";
    if (arguments.inSpace && !method->inSpace)
        return "method " + *arguments.method + " does not solve for the height, as --3d asks";
    if (arguments.height_m && method->inSpace)
        return "method " + *arguments.method + " solves for the height; --height is not for it";
    return std::nullopt;
}

bool isWanted(const MethodInfo& method, const LocateArguments& arguments)
{
    if (method.input == MethodInput::Special || (method.input == MethodInput::Fusion && !arguments.fuse))
        return false;
    if (needsWheels(method.name) && !arguments.odometryFile)
        return false;
    if (needsFloorTags(method.name) && !arguments.floorFile)
        return false;
    if (needsRanges(method) && arguments.inputs.empty())
        return false;
    return method.inSpace || !arguments.inSpace;
}

std::vector<std::string_view> methodsOf(const LocateArguments& arguments)
{
    if (arguments.method == automaticMethod)
        return {automaticMethod};
    if (arguments.method && *arguments.method != everyMethod)
        return {estimation::findMethod(*arguments.method)->name};
    std::vector<std::string_view> methods;
    if (arguments.method) {
        for (const MethodInfo& method : estimation::allMethods())
            if (isWanted(method, arguments))
                methods.push_back(method.name);
    } else if (arguments.inSpace) {
        methods.push_back(defaultInSpace);
    } else if (arguments.fuse) {
        methods.push_back(arguments.odometryFile ? defaultWithWheels : defaultWithoutWheels);
    } else {
        methods.push_back(automaticMethod);
    }
    return methods;
}

Result<void> readTruth(const std::string& path, LocateSetup& setup, std::ostream& err)
{
    const auto text = readTextStream(path, largestTruthFile);
    if (!text)
        return std::unexpected(text.error());
    auto truth = recording::readTruthCsv(*text);
    if (!truth)
        return std::unexpected(inFile(path, truth.error()));
    report(path, truth->problems, err);
    setup.someBad = setup.someBad || !truth->problems.empty();
    setup.truth = std::move(*truth);
    return {};
}

Result<void> readAnchors(const LocateArguments& arguments, LocateSetup& setup, std::ostream& err)
{
    if (!arguments.anchorsFile && !arguments.plantFile)
        return {};
    auto anchors = arguments.anchorsFile ? readAnchorFile(*arguments.anchorsFile, err)
                                         : readPlantAnchors(*arguments.plantFile);
    if (!anchors)
        return std::unexpected(anchors.error());
    if (anchors->anchors.size() > estimation::kMaxAnchors)
        return failure(ErrorCode::BadInput,
                       arguments.anchorsFile.value_or(arguments.plantFile.value_or("")) + ": has " +
                           std::to_string(anchors->anchors.size()) + " anchors; at most " +
                           std::to_string(estimation::kMaxAnchors) + " can be used at once");
    setup.anchors = std::move(*anchors);
    return {};
}

} // namespace

std::optional<std::string> whyUsageIsWrong(const LocateArguments& arguments)
{
    if (arguments.listMethods)
        return std::nullopt;
    if (arguments.inputs.empty() && !(arguments.fuse && arguments.floorFile))
        return "name at least one INPUT with ranges";
    if (arguments.inputs.empty() && arguments.odometryFile && !arguments.startPosition)
        return "without an INPUT nothing says where the vehicle stands at first; give --start and --heading";
    if (arguments.inputs.empty() && arguments.calibrate)
        return "--calibrate needs an INPUT with ranges";
    if (arguments.plantFile && arguments.anchorsFile && !arguments.fuse)
        return "--plant and --anchors exclude each other";
    if (arguments.height_m && arguments.inSpace)
        return "--height and --3d exclude each other";
    if (arguments.height_m && !std::isfinite(*arguments.height_m))
        return "--height must be a number";
    if (arguments.calibrate && !arguments.anchorsFile && !arguments.plantFile)
        return "--calibrate needs --anchors or --plant";
    if (arguments.by && !arguments.truthFile)
        return "--by needs --truth";
    if (arguments.fuse && arguments.inSpace && arguments.method == std::nullopt)
        return "--3d needs --method: fusion takes the height as known";
    if (arguments.startPosition && !arguments.startHeading)
        return "--start needs --heading";
    return whyMethodIsWrong(arguments);
}

Result<LocateSetup> readSetup(const LocateArguments& arguments, std::ostream& err)
{
    LocateSetup setup;
    setup.methods = methodsOf(arguments);
    if (const auto read = readAnchors(arguments, setup, err); !read)
        return std::unexpected(read.error());
    if (arguments.truthFile)
        if (const auto read = readTruth(*arguments.truthFile, setup, err); !read)
            return std::unexpected(read.error());
    if (arguments.calibrate) {
        auto calibration =
            UwbCalibration::read(*arguments.calibrate, *setup.anchors, arguments.height_m.value_or(0.0), err);
        if (!calibration)
            return std::unexpected(calibration.error());
        setup.calibration = std::move(*calibration);
    }
    if (arguments.fuse) {
        auto vehicle = readVehicleData(arguments, err, setup.someBad);
        if (!vehicle)
            return std::unexpected(vehicle.error());
        setup.vehicle = std::move(*vehicle);
    }
    return setup;
}

std::string methodTable()
{
    TextTable table;
    table.add({"name", "command", "method", "source"});
    table.add({std::string(automaticMethod), "locate, fuse", "static for a tag that stands, else ekf-los",
               "hardly any range is too short for one place (own; default of locate)"});
    for (const MethodInfo& method : estimation::allMethods()) {
        const char* const command = method.input == MethodInput::Ranges   ? "locate, fuse"
                                    : method.input == MethodInput::Fusion ? "fuse"
                                                                          : "elsewhere";
        table.add({std::string(method.name), command,
                   std::string(method.title) + (method.inSpace ? " (--3d)" : ""),
                   std::string(method.source)});
    }
    return table.text(4);
}

} // namespace agv::app
