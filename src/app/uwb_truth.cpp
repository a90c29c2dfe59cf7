// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/uwb_truth.h"

#include <algorithm>
#include <cmath>

namespace agv::app {

namespace {

using recording::RangeTable;
using recording::TruePlace;
using recording::TruthTable;

/// Rows further apart say nothing of the time between them.
constexpr double longestGap_s = 1.0;
/// A row counts for times this close to it.
constexpr double nearestGap_s = 0.1;

TrueAt placeOf(const TruePlace& place) { return {place.x_m, place.y_m, place.z_m, &place}; }

} // namespace

Result<TruthIndex> TruthIndex::make(const TruthTable& truth, const RangeTable& table)
{
    TruthIndex index;
    std::vector<std::size_t> shared; // of the truth
    for (std::size_t column = 0; column < table.extraColumns.size(); ++column) {
        if (const auto other = truth.otherColumn(table.extraColumns[column])) {
            index.m_extraColumns.push_back(column);
            shared.push_back(*other);
        }
    }
    for (const TruePlace& place : truth.places) {
        std::string key;
        for (const std::size_t column : shared)
            key += place.columns[column] + '\n';
        Places& places = index.m_places[{key, place.tag}];
        if (!places.empty() && !place.time_s)
            return failure(
                ErrorCode::BadInput,
                std::to_string(place.line) + ": line " + std::to_string(places.front()->line) +
                    " has another place for the same ranges; the ranges need a column of the truth "
                    "that tells them apart, such as point or run");
        places.push_back(&place);
    }
    for (auto& [key, places] : index.m_places)
        std::ranges::stable_sort(places, {}, [](const TruePlace* place) { return place->time_s; });
    return index;
}

const TruthIndex::Places* TruthIndex::placesOf(const RangeTable& table, std::size_t row) const
{
    std::string key;
    for (const std::size_t column : m_extraColumns)
        key += std::string(table.extra(row, column)) + '\n';
    auto found = m_places.find({key, table.ranges[row].tag});
    if (found == m_places.end())
        found = m_places.find({key, std::nullopt});
    return found == m_places.end() ? nullptr : &found->second;
}

std::optional<TrueAt> TruthIndex::at(const RangeTable& table, std::size_t row, double time_s) const
{
    const Places* const places = placesOf(table, row);
    return places == nullptr ? std::nullopt : between(*places, time_s);
}

std::optional<TrueAt> TruthIndex::at(double time_s) const
{
    return m_places.size() == 1 ? between(m_places.begin()->second, time_s) : std::nullopt;
}

std::optional<TrueAt> TruthIndex::between(const Places& places, double time_s)
{
    if (!places.front()->time_s)
        return placeOf(*places.front());
    const auto after =
        std::ranges::lower_bound(places, time_s, {}, [](const TruePlace* place) { return *place->time_s; });
    if (after != places.end() && after != places.begin()) {
        const TruePlace& a = **(after - 1);
        const TruePlace& b = **after;
        const double gap = *b.time_s - *a.time_s;
        if (gap > 0.0 && gap <= longestGap_s) {
            const double share = (time_s - *a.time_s) / gap;
            TrueAt place = placeOf(a);
            place.x_m += share * (b.x_m - a.x_m);
            place.y_m += share * (b.y_m - a.y_m);
            if (a.z_m && b.z_m)
                place.z_m = *a.z_m + share * (*b.z_m - *a.z_m);
            return place;
        }
    }
    for (const auto near : {after, after - (after == places.begin() ? 0 : 1)})
        if (near != places.end() && std::abs(*(*near)->time_s - time_s) <= nearestGap_s)
            return placeOf(**near);
    return std::nullopt;
}

} // namespace agv::app
