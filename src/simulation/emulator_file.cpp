// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/emulator_file.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace agv::simulation {
namespace {

constexpr int mostTagsAlong = 1000;
constexpr int mostStops = 360;

/// The texts that appendix A puts around tag and RSSI.
struct Separators {
    const char* beforeTag;
    const char* beforeRssi;
    const char* end;
};

Separators separatorsOf(const EmulatorOptions& options)
{
    return options.readerLike ? Separators{"SCAN:+UID=", "+RSSI=", "<\\r>"} : Separators{" ", " ", " "};
}

Result<void> check(const EmulatorOptions& options)
{
    const auto along = [](int tags) { return tags >= 1 && tags <= mostTagsAlong; };
    if (!along(options.columns) || !along(options.rows))
        return failure(ErrorCode::BadInput, "a field of " + std::to_string(options.columns) + "x" +
                                                std::to_string(options.rows) +
                                                " tags: expected 1x1 to 1000x1000");
    if (options.stops < 1 || options.stops > mostStops)
        return failure(ErrorCode::BadInput,
                       std::to_string(options.stops) + " stops: expected 1 to " + std::to_string(mostStops));
    const std::array numbers{options.pitch_m, options.centre.x,        options.centre.y,
                             options.bearing, options.antennaRadius_m, options.step};
    for (const double number : numbers)
        if (!std::isfinite(number))
            return failure(ErrorCode::BadInput, "a pose, pitch or step that is not a finite number");
    return {};
}

std::string formatted(const char* format, auto... values)
{
    std::array<char, 128> text{};
    const int length = std::snprintf(text.data(), text.size(), format, values...);
    return {text.data(), static_cast<std::size_t>(std::max(0, length))};
}

/// As MATLAB's fprintf('%6d\n', value): a value with a fraction is written with %e.
std::string matlabNumber(double value)
{
    if (value == std::floor(value) && std::abs(value) < 1e9)
        return formatted("%6ld\n", static_cast<long>(value));
    return formatted("%e\n", value);
}

std::string line(const EmulatorOptions& options, double angle_deg, EmulatorReading reading)
{
    const Separators text = separatorsOf(options);
    const std::string tag = options.hexadecimal ? formatted("%016X", static_cast<unsigned>(reading.tag))
                                                : std::to_string(reading.tag);
    return formatted("%g ", angle_deg) + text.beforeTag + tag + text.beforeRssi +
           std::to_string(reading.rssi) + text.end + "\n";
}

Result<void> write(const std::filesystem::path& path, const std::string& text)
{
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << text;
    file.close();
    if (!file)
        return failure(ErrorCode::Io, "cannot write " + path.string() + ": " + std::strerror(errno));
    return {};
}

} // namespace

Result<std::vector<std::vector<EmulatorReading>>> emulateTurn(const EmulatorOptions& options)
{
    if (auto good = check(options); !good)
        return std::unexpected(good.error());
    const auto tags = tagGrid(options.columns, options.rows, options.pitch_m, {0.0, 0.0}, TagUid{1});
    std::vector<std::vector<EmulatorReading>> stops(static_cast<std::size_t>(options.stops));
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const Pose2 turned{options.centre, options.bearing + static_cast<double>(i) * options.step};
        const Point2 antenna = fromVehicleFrame(turned, {options.antennaRadius_m, 0.0});
        for (const FloorTag& tag : tags)
            if (const auto rssi = rssiAt(options.table, distance(tag.position, antenna)))
                stops[i].push_back({tag.number, *rssi});
    }
    return stops;
}

Result<std::string> emulatorText(const EmulatorOptions& options)
{
    const auto stops = emulateTurn(options);
    if (!stops)
        return std::unexpected(stops.error());
    std::string text;
    std::vector<int> before(static_cast<std::size_t>(options.columns * options.rows), 0);
    for (std::size_t i = 0; i < stops->size(); ++i) {
        const double angle_deg = degFromRad(static_cast<double>(i) * options.step);
        if (!options.changesOnly) {
            for (const EmulatorReading& reading : (*stops)[i])
                text += line(options, angle_deg, reading);
            continue;
        }
        std::vector<int> now(before.size(), 0);
        for (const EmulatorReading& reading : (*stops)[i])
            now[static_cast<std::size_t>(reading.tag - 1)] = reading.rssi;
        for (std::size_t tag = 0; tag < now.size(); ++tag)
            if (now[tag] != before[tag])
                text += line(options, angle_deg, {static_cast<int>(tag + 1), now[tag]});
        before = now;
    }
    return text;
}

std::string emulatorSideText(const EmulatorOptions& options)
{
    const auto centimetres = [](double m) { return std::round(m * 1e6) / 1e4; };
    return matlabNumber(static_cast<double>(options.columns) * options.rows) +
           matlabNumber(centimetres((options.columns - 1) * options.pitch_m)) +
           formatted("%6.4f\n", options.bearing) + matlabNumber(centimetres(options.centre.x)) +
           matlabNumber(centimetres(options.centre.y));
}

Result<EmulatorPaths> writeEmulatorFiles(const std::filesystem::path& folder, const EmulatorOptions& options)
{
    const auto text = emulatorText(options);
    if (!text)
        return std::unexpected(text.error());
    if (text->empty())
        return failure(
            ErrorCode::BadInput,
            "no tag of the " + std::to_string(options.columns) + "x" + std::to_string(options.rows) +
                " field comes into range at any stop, so the file would be empty: choose a place on "
                "the field, which goes to x " +
                formatted("%g", mmFromMetres((options.columns - 1) * options.pitch_m)) + ", y " +
                formatted("%g mm", mmFromMetres((options.rows - 1) * options.pitch_m)));
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return failure(ErrorCode::Io, "cannot make the folder " + folder.string() + ": " + error.message());
    const std::string number = std::to_string(options.fileNumber);
    EmulatorPaths paths{folder / ("Meas_StartingProc_like_reader_real_data" + number + ".txt"),
                        folder / ("NumTags" + number + ".txt")};
    if (auto written = write(paths.readings, *text); !written)
        return std::unexpected(written.error());
    if (auto written = write(paths.side, emulatorSideText(options)); !written)
        return std::unexpected(written.error());
    return paths;
}

} // namespace agv::simulation
