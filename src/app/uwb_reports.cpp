// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/uwb_reports.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace agv::app {

namespace {

using recording::RangeTable;

constexpr double stepBack_s = 1.0;
/// Reports a value of a column has to last on average for the column to group them.
constexpr double leastReportsPerValue = 3.0;

bool alwaysGroups(const std::string& column, std::span<const std::string> keys)
{
    static constexpr std::array names{"point", "run", "session"};
    return std::ranges::find(names, column) != names.end() || std::ranges::find(keys, column) != keys.end();
}

class Grouping {
public:
    Grouping(const RangeTable& table, std::span<const std::string> keys) : m_table(table)
    {
        for (std::size_t column = 0; column < table.extraColumns.size(); ++column)
            if (alwaysGroups(table.extraColumns[column], keys))
                m_list.groupColumns.push_back(column);
    }

    ReportList list()
    {
        collect();
        for (std::size_t column = 0; column < m_table.extraColumns.size(); ++column)
            if (std::ranges::find(m_list.groupColumns, column) == m_list.groupColumns.end() && groups(column))
                m_list.groupColumns.push_back(column);
        std::ranges::sort(m_list.groupColumns);
        for (UwbReport& report : m_list.reports)
            report.time_s = medianTime(report);
        numberTracks();
        return std::move(m_list);
    }

private:
    void collect()
    {
        std::map<int, std::size_t> open; // by tag
        for (std::size_t row = 0; row < m_table.ranges.size(); ++row) {
            const RangeMeasurement& range = m_table.ranges[row];
            if (range.kind != RangeKind::TagAnchor)
                continue;
            const auto [place, isNew] = open.try_emplace(range.tag, m_list.reports.size());
            if (isNew || !belongs(row, m_list.reports[place->second])) {
                place->second = m_list.reports.size();
                m_list.reports.push_back({range.time_s, range.tag, 0, {}});
            }
            m_list.reports[place->second].rows.push_back(row);
        }
    }

    bool belongs(std::size_t row, const UwbReport& report) const
    {
        const RangeMeasurement& range = m_table.ranges[row];
        const std::size_t first = report.rows.front();
        const RangeMeasurement& before = m_table.ranges[first];
        const bool sameMoment =
            range.sequence == before.sequence && (range.sequence >= 0 || range.time_s == before.time_s);
        return sameMoment &&
               std::ranges::all_of(m_list.groupColumns,
                                   [&](std::size_t column) {
                                       return m_table.extra(row, column) == m_table.extra(first, column);
                                   }) &&
               std::ranges::none_of(report.rows, [&](std::size_t other) {
                   return m_table.ranges[other].anchor == range.anchor;
               });
    }

    bool groups(std::size_t column) const
    {
        std::map<int, std::string_view> last; // by tag
        std::size_t values = 0;
        for (const UwbReport& report : m_list.reports) {
            const std::string_view value = m_table.extra(report.rows.front(), column);
            for (const std::size_t row : report.rows)
                if (m_table.extra(row, column) != value)
                    return false;
            const auto [before, isNew] = last.try_emplace(report.tag, value);
            values += isNew || before->second != value ? 1U : 0U;
            before->second = value;
        }
        return static_cast<double>(m_list.reports.size()) >=
               leastReportsPerValue * static_cast<double>(values);
    }

    double medianTime(const UwbReport& report) const
    {
        std::vector<double> times;
        for (const std::size_t row : report.rows)
            times.push_back(m_table.ranges[row].time_s);
        const auto middle = times.begin() + static_cast<std::ptrdiff_t>((times.size() - 1) / 2);
        std::ranges::nth_element(times, middle);
        return *middle;
    }

    void numberTracks()
    {
        struct Numbered {
            std::size_t number;
            double time_s;
        };
        std::map<std::pair<int, std::string>, Numbered> tracks;
        for (UwbReport& report : m_list.reports) {
            const auto [track, isNew] = tracks.try_emplace({report.tag, m_list.groupOf(m_table, report)},
                                                           Numbered{m_list.tracks, report.time_s});
            if (isNew || report.time_s < track->second.time_s - stepBack_s)
                track->second.number = m_list.tracks++;
            track->second.time_s = report.time_s;
            report.track = track->second.number;
        }
    }

    const RangeTable& m_table;
    ReportList m_list;
};

} // namespace

std::string ReportList::groupOf(const RangeTable& table, const UwbReport& report) const
{
    std::string group;
    for (const std::size_t column : groupColumns) {
        if (!group.empty())
            group += ' ';
        group += table.extra(report.rows.front(), column);
    }
    return group;
}

ReportList groupReports(const RangeTable& table, std::span<const std::string> keys)
{
    return Grouping(table, keys).list();
}

bool comesInTurns(const ReportList& list)
{
    const auto few =
        std::ranges::count_if(list.reports, [](const UwbReport& r) { return r.rows.size() < 3; });
    return 2 * static_cast<std::size_t>(few) > list.reports.size();
}

ReportList roundsOf(const RangeTable& table, const ReportList& list)
{
    ReportList rounds{{}, list.groupColumns, list.tracks};
    std::map<std::size_t, std::size_t> open; // by track
    for (const UwbReport& report : list.reports) {
        const auto [place, isNew] = open.try_emplace(report.track, rounds.reports.size());
        const auto isIn = [&](std::size_t row) {
            return std::ranges::any_of(rounds.reports[place->second].rows, [&](std::size_t other) {
                return table.ranges[other].anchor == table.ranges[row].anchor;
            });
        };
        if (isNew || std::ranges::any_of(report.rows, isIn)) {
            place->second = rounds.reports.size();
            rounds.reports.push_back(report);
            continue;
        }
        UwbReport& round = rounds.reports[place->second];
        round.rows.insert(round.rows.end(), report.rows.begin(), report.rows.end());
        round.time_s = report.time_s;
    }
    return rounds;
}

} // namespace agv::app
