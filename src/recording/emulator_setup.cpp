// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/emulator_setup.h"

#include "core/text_file.h"
#include "recording/text_lines.h"

#include <cmath>

namespace agv::recording {

Result<EmulatorSetup> parseEmulatorSetup(std::string_view text)
{
    std::vector<double> numbers;
    for (const TextLine& line : linesOf(text)) {
        for (const std::string_view token : tokensOf(line.text)) {
            const auto number = parseNumber(token);
            if (!number)
                return failure(ErrorCode::BadInput, "line " + std::to_string(line.number) + ": " +
                                                        inQuotes(token) + " is not a number");
            numbers.push_back(*number);
        }
    }
    constexpr std::size_t expectedNumbers = 5;
    if (numbers.size() != expectedNumbers)
        return failure(ErrorCode::BadInput,
                       "holds " + std::to_string(numbers.size()) +
                           " numbers, not tags, length, start angle, start x and start y");
    constexpr double mostTags = 1e6;
    constexpr double mostLength_cm = 1e6;
    if (!(numbers[0] >= 1.0 && numbers[0] <= mostTags) || numbers[0] != std::floor(numbers[0]))
        return failure(ErrorCode::BadInput, "the number of tags must be a whole number from 1 to a million");
    if (!(numbers[1] > 0.0 && numbers[1] <= mostLength_cm))
        return failure(ErrorCode::BadInput, "the length of the plant must be over 0 and up to 10 km");
    return EmulatorSetup{static_cast<int>(numbers[0]),
                         numbers[1] / 100.0,
                         numbers[2],
                         {numbers[3] / 100.0, numbers[4] / 100.0}};
}

std::optional<EmulatorSetup> findEmulatorSetup(const std::filesystem::path& readings)
{
    constexpr std::size_t largestFile = std::size_t{1024} * 1024;
    const std::string stem = readings.stem().string();
    const std::size_t lastOther = stem.find_last_not_of("0123456789");
    const std::string digits = lastOther == std::string::npos ? stem : stem.substr(lastOther + 1);
    const auto text = readTextFile(readings.parent_path() / ("NumTags" + digits + ".txt"), largestFile);
    if (!text)
        return std::nullopt;
    const auto setup = parseEmulatorSetup(*text);
    return setup ? std::optional(*setup) : std::nullopt;
}

std::optional<std::vector<FloorTag>> fieldOf(const EmulatorSetup& setup, TagUid firstUid)
{
    constexpr double pitch_m = 0.1;
    const double gaps = setup.length_m / pitch_m;
    const int columns = static_cast<int>(std::lround(gaps)) + 1;
    if (std::abs(gaps - std::round(gaps)) > 1e-6 || setup.tags % columns != 0)
        return std::nullopt;
    return tagGrid(columns, setup.tags / columns, pitch_m, {0.0, 0.0}, firstUid);
}

} // namespace agv::recording
