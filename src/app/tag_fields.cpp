// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tag_fields.h"

#include <array>
#include <charconv>
#include <optional>

namespace agv::app {

namespace {

constexpr TagUid firstArtificialUid{0xE004000000000001};

/// Table 13 of the seed, tags 1 to 9; they differ in the last three digits.
constexpr std::uint64_t commonUid = 0xE00401503A5BD000;
constexpr std::array<std::uint64_t, 9> seedUids{0xAE4, 0x586, 0xBF4, 0x689, 0x785,
                                                0x691, 0x47A, 0xADC, 0x78D};

std::optional<int> parseCount(std::string_view text)
{
    constexpr int most = 1000;
    int count = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    const bool isWhole = !text.empty() && error == std::errc{} && stop == text.data() + text.size();
    return isWhole && count >= 1 && count <= most ? std::optional(count) : std::nullopt;
}

std::vector<FloorTag> fieldOf(int columns, int rows, double pitch)
{
    std::vector<FloorTag> tags = tagGrid(columns, rows, pitch, {0.0, 0.0}, firstArtificialUid);
    if (columns == 3 && rows == 3) {
        for (std::size_t tag = 0; tag < seedUids.size(); ++tag)
            tags[tag].uid = TagUid{commonUid + seedUids[tag]};
    }
    return tags;
}

} // namespace

std::vector<FloorTag> seedTestField() { return fieldOf(3, 3, metresFromMm(100.0)); }

Result<std::vector<FloorTag>> parseField(std::string_view text, double pitch)
{
    const std::size_t cross = text.find('x');
    const auto columns = parseCount(text.substr(0, cross));
    const auto rows = cross == std::string_view::npos ? std::nullopt : parseCount(text.substr(cross + 1));
    if (!columns || !rows)
        return failure(ErrorCode::BadInput, "'" + std::string(text) +
                                                "' is not a field; expected columns x rows, such as 11x11, "
                                                "each from 1 to 1000");
    return fieldOf(*columns, *rows, pitch);
}

} // namespace agv::app
