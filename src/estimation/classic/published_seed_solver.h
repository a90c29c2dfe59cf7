// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace agv::estimation {

/// How the published program ends. Everything but Ok and NotANumber is a crash or an endless loop there.
enum class PublishedStatus : std::uint8_t {
    Ok,
    HangPair,      ///< appendix F: the search for the second pair of stops never advances
    HangBest,      ///< appendix K: the search for three tags counts down through 2^32 values
    Index,         ///< IndexOutOfRangeException
    NotANumber,    ///< an antenna position is int.MinValue: three of its tags are collinear or equal
    DivideByZero,  ///< DivideByZeroException: the two lines of appendix G are parallel
    ArrayOverflow, ///< appendix E: an eighth tag at one stop
};

/// "ok", "hang_pair", "hang_best", "index", "nan", "div0", "array_overflow"
const char* toText(PublishedStatus status);

/// Integer coordinates as the published program keeps them.
struct PublishedPoint {
    std::int32_t x = 0;
    std::int32_t y = 0;
    friend bool operator==(const PublishedPoint&, const PublishedPoint&) = default;
};

/// Return value of CorrectID_Distance (appendix K).
struct PublishedChoice {
    std::array<int, 3> column{};   ///< which tags of the row
    std::array<int, 3> distance{}; ///< 0 max, 1 middle, 2 min
    friend bool operator==(const PublishedChoice&, const PublishedChoice&) = default;
};

/// What the published program has computed when it ends; later members are empty when it ends early.
struct PublishedResult {
    PublishedStatus status = PublishedStatus::Ok;
    std::vector<int> counts;                       ///< tags at each of the 8 stops
    std::optional<std::pair<int, int>> firstPair;  ///< 0-based stops, half a turn apart
    std::optional<std::pair<int, int>> secondPair; ///< 0-based stops, half a turn apart
    std::vector<PublishedChoice> choices;          ///< one for each stop of the pairs
    std::vector<PublishedPoint> antennas;          ///< mm
    std::optional<PublishedPoint> centre;          ///< mm
    std::optional<double> antennaBearing_deg;      ///< "angleTemp": centre to the first antenna
    std::optional<double> heading_deg;             ///< "angle"
};

/// Tag number and RSSI, in order of reading.
using PublishedRow = std::vector<std::pair<int, int>>;

/// The seed's program of 2018 (appendices E to L) with its arithmetic and its defects, for comparisons
/// between old and new. It reproduces C# on x86: 32-bit integers that wrap, (int)NaN == int.MinValue,
/// division towards zero. Where the program would never end or throw, it returns that as a status.
/// Not for driving: ClassicSolver is the repaired algorithm.
class PublishedSeedSolver {
public:
    /// `tagPositions_cm[n - 1]` is the position of tag n (IDtoPOS of appendix I), whole centimetres.
    explicit PublishedSeedSolver(std::vector<PublishedPoint> tagPositions_cm);

    /// Solves a turn of 8 stops of 45 degrees; further rows are ignored, missing ones are empty.
    PublishedResult solve(const std::vector<PublishedRow>& rows) const;

private:
    std::vector<PublishedPoint> m_tagPositions_cm;
};

} // namespace agv::estimation
