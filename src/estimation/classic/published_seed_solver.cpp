// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/published_seed_solver.h"

#include "core/units.h"
#include "estimation/classic/rssi_branch.h"

#include <algorithm>
#include <cmath>
#include <expected>
#include <limits>
#include <span>

namespace agv::estimation {

namespace {

constexpr int stopCount = 8;
constexpr int halfTurn = 4;
constexpr int rowWidth = 7;
constexpr int gridColumnStep = 11; ///< appendix J: neighbours are id +-1 and +-11 whatever the field
constexpr std::int32_t minInt = std::numeric_limits<std::int32_t>::min();

/// Appendix H, cm: far, middle and near distance of each RSSI.
constexpr std::array<std::array<double, 8>, 3> distances_cm{{{14, 9.75, 9.0, 8.0, 7.0, 6.0, 3.5, 2.75},
                                                             {5.0, 5.1, 5.3, 5.5, 5.8, 4.0, 3.5, 2.75},
                                                             {5.0, 4.7, 4.5, 4.3, 4.2, 4.0, 3.5, 2.75}}};

template<typename T>
using Outcome = std::expected<T, PublishedStatus>;

/// One row of Init_array: ids then RSSI, zero where empty.
struct TableRow {
    std::array<int, rowWidth> id{};
    std::array<int, rowWidth> rssi{};
    int count = 0;
};
using Table = std::array<TableRow, stopCount>;

/// C# unchecked (int)double on x86.
std::int32_t truncated(double value)
{
    if (!(std::abs(value) < 2147483648.0))
        return minInt;
    return static_cast<std::int32_t>(value);
}

/// C# int arithmetic: the low 32 bits.
std::int32_t wrapped(std::int64_t value)
{
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(value));
}
std::int32_t product(std::int32_t a, std::int32_t b) { return wrapped(std::int64_t{a} * b); }
std::int32_t difference(std::int32_t a, std::int32_t b) { return wrapped(std::int64_t{a} - b); }

/// Appendix E. The test for duplicates also compares the id with column 7, the row's first RSSI.
Outcome<Table> fillTable(const std::vector<PublishedRow>& rows)
{
    Table table;
    for (std::size_t stop = 0; stop < std::min<std::size_t>(rows.size(), stopCount); ++stop) {
        TableRow& row = table[stop];
        for (const auto& [id, rssi] : rows[stop]) {
            const std::span known(row.id.data(), static_cast<std::size_t>(row.count));
            if (std::ranges::find(known, id) != known.end() || (row.count > 0 && id == row.rssi[0]))
                continue;
            if (row.count == rowWidth)
                return std::unexpected(PublishedStatus::ArrayOverflow);
            row.id[static_cast<std::size_t>(row.count)] = id;
            row.rssi[static_cast<std::size_t>(row.count)] = rssi;
            ++row.count;
        }
    }
    return table;
}

struct Pairs {
    std::pair<int, int> first{0, 0};
    std::pair<int, int> second{0, 0};
};

/// Appendix F. A failed search for the second pair starts the search for the first one again, from the
/// stop reached; the first pair may stay {0, 0}.
Outcome<Pairs> choosePairs(const std::vector<int>& counts)
{
    constexpr int enoughTags = 3;
    const auto rowHasEnough = [&](int row) { return counts[static_cast<std::size_t>(row)] >= enoughTags; };
    Pairs pairs;
    int count = 0;
    while (true) {
        while (true) {
            if (count >= stopCount || (rowHasEnough(count) && count + halfTurn >= stopCount))
                return std::unexpected(PublishedStatus::Index);
            if (rowHasEnough(count)) {
                if (rowHasEnough(count + halfTurn)) {
                    pairs.first = {count, count + halfTurn};
                    break;
                }
                if (count >= 2)
                    break; // prints NO SOLUTION FOUND and goes on
            }
            ++count;
        }
        ++count;
        if (count >= stopCount)
            return std::unexpected(PublishedStatus::Index);
        if (!rowHasEnough(count))
            return std::unexpected(PublishedStatus::HangPair);
        if (count + halfTurn >= stopCount)
            return std::unexpected(PublishedStatus::Index);
        if (rowHasEnough(count + halfTurn)) {
            pairs.second = {count, count + halfTurn};
            return pairs;
        }
    }
}

/// Appendix J. The zeros of empty cells count as well.
std::vector<int> neighbourCounts(const TableRow& row)
{
    std::vector<int> counts;
    for (int tag = 0; tag < row.count; ++tag) {
        const int id = row.id[static_cast<std::size_t>(tag)];
        int count = 0;
        for (const int neighbour : {id - gridColumnStep, id - 1, id + 1, id + gridColumnStep})
            count += static_cast<int>(std::ranges::count(row.id, neighbour));
        counts.push_back(count);
    }
    return counts;
}

/// Appendix K. Fewer than three tags leave the result at zero; the caller never asks for them.
Outcome<PublishedChoice> chooseTags(const TableRow& row)
{
    constexpr int mostNeighbours = 4;
    PublishedChoice choice;
    if (row.count < 3)
        return choice;
    const std::vector<int> neighbours = neighbourCounts(row);
    const auto branches =
        chooseBranches(neighbours, std::span(row.rssi.data(), static_cast<std::size_t>(row.count)));
    std::size_t chosen = 0;
    for (int wanted = mostNeighbours; chosen < 3; --wanted) {
        if (wanted < 0)
            return std::unexpected(PublishedStatus::HangBest);
        for (std::size_t tag = 0; tag < neighbours.size() && chosen < 3; ++tag) {
            if (neighbours[tag] != wanted)
                continue;
            choice.column[chosen] = static_cast<int>(tag);
            choice.distance[chosen] = static_cast<int>(branches[tag]);
            ++chosen;
        }
    }
    return choice;
}

struct Centimetres {
    double x = 0.0;
    double y = 0.0;
};

/// Appendix H. Collinear or equal tags give 0/0, and (int)NaN is int.MinValue.
PublishedPoint trilaterated(const std::array<PublishedPoint, 3>& tag, const std::array<double, 3>& r)
{
    const Centimetres d{static_cast<double>(tag[1].x - tag[0].x), static_cast<double>(tag[1].y - tag[0].y)};
    const Centimetres aux{static_cast<double>(tag[2].x - tag[0].x), static_cast<double>(tag[2].y - tag[0].y)};
    const double length = std::hypot(d.x, d.y);
    const Centimetres ex{d.x / length, d.y / length};
    const double i = ex.x * aux.x + ex.y * aux.y;
    const Centimetres aux2{aux.x - i * ex.x, aux.y - i * ex.y};
    const double norm = std::hypot(aux2.x, aux2.y);
    const Centimetres ey{aux2.x / norm, aux2.y / norm};
    const double j = ey.x * aux.x + ey.y * aux.y;
    const double x = (r[0] * r[0] - r[1] * r[1] + length * length) / (2 * length);
    const double y = (r[0] * r[0] - r[2] * r[2] + i * i + j * j) / (2 * j) - i * (x / j);
    return {truncated(10 * (tag[0].x + x * ex.x + y * ey.x)),
            truncated(10 * (tag[0].y + x * ex.y + y * ey.y))};
}

Outcome<PublishedPoint> antennaAt(const TableRow& row, const PublishedChoice& choice,
                                  const std::vector<PublishedPoint>& tagPositions_cm)
{
    std::array<PublishedPoint, 3> tags;
    std::array<double, 3> radii{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto column = static_cast<std::size_t>(choice.column[k]);
        const int id = row.id[column];
        const int rssi = row.rssi[column];
        if (id < 1 || static_cast<std::size_t>(id) > tagPositions_cm.size() || rssi < 0 || rssi > 7)
            return std::unexpected(PublishedStatus::Index);
        tags[k] = tagPositions_cm[static_cast<std::size_t>(id - 1)];
        radii[k] = distances_cm[static_cast<std::size_t>(choice.distance[k])][static_cast<std::size_t>(rssi)];
    }
    return trilaterated(tags, radii);
}

/// Appendix G in int arithmetic.
Outcome<PublishedPoint> centreOf(const std::vector<PublishedPoint>& a)
{
    const std::int32_t dx12 = difference(a[1].x, a[0].x);
    const std::int32_t dy12 = difference(a[1].y, a[0].y);
    const std::int32_t dx34 = difference(a[3].x, a[2].x);
    const std::int32_t dy34 = difference(a[3].y, a[2].y);
    const std::int32_t c12 = difference(product(a[1].x, a[0].y), product(a[0].x, a[1].y));
    const std::int32_t c34 = difference(product(a[3].x, a[2].y), product(a[2].x, a[3].y));
    const std::int32_t denominator = difference(product(dy34, dx12), product(dy12, dx34));
    const std::int32_t x = difference(product(dx34, c12), product(dx12, c34));
    const std::int32_t y =
        difference(product(wrapped(-std::int64_t{dy12}), c34), product(wrapped(-std::int64_t{dy34}), c12));
    if (denominator == 0)
        return std::unexpected(PublishedStatus::DivideByZero);
    return PublishedPoint{wrapped(std::int64_t{x} / denominator), wrapped(std::int64_t{y} / denominator)};
}

bool isNumber(PublishedPoint point) { return point.x != minInt && point.y != minInt; }

} // namespace

const char* toText(PublishedStatus status)
{
    switch (status) {
    case PublishedStatus::Ok:
        return "ok";
    case PublishedStatus::HangPair:
        return "hang_pair";
    case PublishedStatus::HangBest:
        return "hang_best";
    case PublishedStatus::Index:
        return "index";
    case PublishedStatus::NotANumber:
        return "nan";
    case PublishedStatus::DivideByZero:
        return "div0";
    case PublishedStatus::ArrayOverflow:
        return "array_overflow";
    }
    return "unknown";
}

PublishedSeedSolver::PublishedSeedSolver(std::vector<PublishedPoint> tagPositions_cm)
    : m_tagPositions_cm(std::move(tagPositions_cm))
{}

PublishedResult PublishedSeedSolver::solve(const std::vector<PublishedRow>& rows) const
{
    PublishedResult result;
    const auto endWith = [&](PublishedStatus status) {
        result.status = status;
        return result;
    };

    const Outcome<Table> table = fillTable(rows);
    if (!table)
        return endWith(table.error());
    for (const TableRow& row : *table)
        result.counts.push_back(row.count);

    const Outcome<Pairs> pairs = choosePairs(result.counts);
    if (!pairs)
        return endWith(pairs.error());
    result.firstPair = pairs->first;
    result.secondPair = pairs->second;

    for (const int stop :
         {pairs->first.first, pairs->first.second, pairs->second.first, pairs->second.second}) {
        const TableRow& row = (*table)[static_cast<std::size_t>(stop)];
        const Outcome<PublishedChoice> choice = chooseTags(row);
        if (!choice)
            return endWith(choice.error());
        result.choices.push_back(*choice);
        const Outcome<PublishedPoint> antenna = antennaAt(row, *choice, m_tagPositions_cm);
        if (!antenna)
            return endWith(antenna.error());
        result.antennas.push_back(*antenna);
    }

    const Outcome<PublishedPoint> centre = centreOf(result.antennas);
    if (!centre)
        return endWith(centre.error());
    result.centre = *centre;
    const PublishedPoint first = result.antennas.front();
    result.antennaBearing_deg =
        degFromRad(std::atan2(difference(first.y, centre->y), difference(first.x, centre->x)));
    const double angle = *result.antennaBearing_deg - 45.0 * pairs->first.first;
    result.heading_deg = angle <= 0.0 ? angle + 180.0 : angle - 180.0;
    const bool allNumbers = std::ranges::all_of(result.antennas, isNumber);
    return endWith(allNumbers ? PublishedStatus::Ok : PublishedStatus::NotANumber);
}

} // namespace agv::estimation
