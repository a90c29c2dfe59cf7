// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/locate_output.h"

#include "recording/csv_text.h"
#include "recording/number_text.h"
#include "recording/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

namespace agv::app {

namespace {

using recording::numberText;

constexpr const char* notKnown = "-";

/// A number with a point, whatever the locale.
std::string fixedText(double value, int decimals)
{
    std::array<char, 64> text{};
    const double shown = std::clamp(value, -1e30, 1e30);
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), shown, std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

std::string inMm(double length_m) { return fixedText(mmFromMetres(length_m), 1); }

/// Text that looks like a number stays one.
std::string asField(const std::string& text)
{
    return recording::parseNumber(text) ? text : recording::csvField(text);
}

std::string joined(const std::vector<std::string>& fields)
{
    std::string line;
    for (const std::string& field : fields)
        line += (line.empty() ? "" : ",") + field;
    return line;
}

std::string backOf(const Outcome& outcome)
{
    const ReportFix& fix = outcome.fix;
    std::vector<std::string> fields{recording::exactNumberText(outcome.report.time_s),
                                    outcome.report.tag >= 0 ? std::to_string(outcome.report.tag)
                                                            : std::string(),
                                    fix.ok() ? "ok" : recording::csvField(estimation::toText(fix.status))};
    for (int axis = 0; axis < 3; ++axis)
        fields.push_back(fix.ok() ? numberText(fix.position(axis)) : std::string());
    for (int axis = 0; axis < 3; ++axis)
        fields.push_back(fix.ok() && fix.sd(axis) > 0.0 ? numberText(fix.sd(axis)) : std::string());
    fields.push_back(fix.ok() && fix.heading ? numberText(degFromRad(*fix.heading)) : std::string());
    fields.push_back(std::to_string(outcome.report.rows.size()));
    fields.push_back(std::to_string(fix.rejected));
    return joined(fields);
}

std::string truthOf(const Outcome& outcome)
{
    if (!outcome.truth)
        return ",,,";
    const TrueAt& truth = *outcome.truth;
    const double error =
        std::hypot(outcome.fix.position.x() - truth.x_m, outcome.fix.position.y() - truth.y_m);
    return numberText(truth.x_m) + "," + numberText(truth.y_m) + "," +
           (truth.z_m ? numberText(*truth.z_m) : std::string()) + "," +
           (outcome.fix.ok() ? numberText(error) : std::string());
}

} // namespace

void ErrorRow::add(const Outcome& outcome)
{
    ++m_reports;
    if (!outcome.fix.ok())
        return;
    ++m_fixes;
    const double time_s = outcome.report.time_s;
    Span& span = m_spans.try_emplace(outcome.report.track, Span{time_s, time_s, 0}).first->second;
    span.last_s = time_s;
    ++span.fixes;
    if (!outcome.truth)
        return;
    Eigen::Vector3d error(outcome.fix.position.x() - outcome.truth->x_m,
                          outcome.fix.position.y() - outcome.truth->y_m, 0.0);
    if (m_inSpace && outcome.truth->z_m)
        error.z() = outcome.fix.position.z() - *outcome.truth->z_m;
    addError(error);
}

void ErrorRow::addError(const Eigen::Vector3d& error)
{
    m_position.add(error.norm());
    m_circular.add(error.head<2>().norm());
    m_sum += error;
}

std::vector<std::string> ErrorRow::titles(bool inSpace)
{
    std::vector<std::string> titles{"n", "bias_x", "bias_y"};
    if (inSpace)
        titles.emplace_back("bias_z");
    for (const char* title :
         {"min", "mean", "rmse", "median", "ce50", "ce75", "ce95", "max", "available", "rate"})
        titles.emplace_back(title);
    return titles;
}

std::string ErrorRow::rate() const
{
    double time_s = 0.0;
    std::size_t steps = 0;
    for (const auto& [track, span] : m_spans) {
        time_s += std::max(span.last_s - span.first_s, 0.0);
        steps += span.fixes - 1;
    }
    return time_s > 0.0 ? fixedText(static_cast<double>(steps) / time_s, 2) : notKnown;
}

std::vector<std::string> ErrorRow::cells() const
{
    const std::size_t n = m_position.size();
    std::vector<std::string> cells{std::to_string(m_hasTruth ? n : m_fixes)};
    const auto put = [&](double length_m) { cells.push_back(n > 0 ? inMm(length_m) : notKnown); };
    const double count = static_cast<double>(std::max<std::size_t>(n, 1));
    for (int axis = 0; axis < (m_inSpace ? 3 : 2); ++axis)
        put(m_sum(axis) / count);
    put(m_position.quantile(0.0));
    put(m_position.mean());
    put(m_position.rms());
    put(m_position.quantile(0.5));
    for (const double quantile : {0.50, 0.75, 0.95})
        put(m_circular.quantile(quantile));
    put(m_position.max());
    const double share =
        static_cast<double>(m_fixes) / static_cast<double>(std::max<std::size_t>(m_reports, 1));
    cells.push_back(m_reports > 0 ? fixedText(100.0 * share, 1) : notKnown);
    cells.push_back(rate());
    return cells;
}

std::string TextTable::text(std::size_t left) const
{
    std::vector<std::size_t> widths;
    for (const auto& row : m_rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const auto& row : m_rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widths[i] - row[i].size(), ' ');
            line += (i > 0 ? "  " : "") + (i < left ? row[i] + blanks : blanks + row[i]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string valueOf(const recording::RangeTable& table, const UwbReport& report, std::size_t column)
{
    const std::string_view first = table.extra(report.rows.front(), column);
    if (std::ranges::all_of(report.rows, [&](std::size_t row) { return table.extra(row, column) == first; }))
        return std::string(first);
    std::string values;
    for (const std::size_t row : report.rows) {
        values += values.empty() ? "" : " ";
        values += table.extra(row, column);
    }
    return values;
}

void PositionCsv::add(const std::string& file, std::string_view method, const recording::RangeTable& table,
                      const Outcome& outcome)
{
    if (m_columnSets.empty() || m_columnSets.back() != table.extraColumns)
        m_columnSets.push_back(table.extraColumns);
    Row row{recording::csvField(file) + "," + std::string(method),
            m_columnSets.size() - 1,
            {},
            backOf(outcome),
            truthOf(outcome)};
    for (std::size_t column = 0; column < table.extraColumns.size(); ++column)
        row.extras.push_back(asField(valueOf(table, outcome.report, column)));
    m_rows.push_back(std::move(row));
}

std::string PositionCsv::text(bool withTruth) const
{
    std::vector<std::string> all; // extra columns of every file
    for (const auto& columns : m_columnSets)
        for (const std::string& column : columns)
            if (std::ranges::find(all, column) == all.end())
                all.push_back(column);
    std::string text = "file,method";
    for (const std::string& column : all)
        text += "," + recording::csvField(column);
    text += ",t_s,tag,status,x_m,y_m,z_m,sd_x_m,sd_y_m,sd_z_m,heading_deg,ranges,rejected";
    text += withTruth ? ",true_x_m,true_y_m,true_z_m,error_m\r\n" : "\r\n";
    for (const Row& row : m_rows) {
        text += row.front;
        const std::vector<std::string>& columns = m_columnSets[row.columns];
        for (const std::string& column : all) {
            const auto place = std::ranges::find(columns, column);
            text += ",";
            if (place != columns.end())
                text += row.extras[static_cast<std::size_t>(place - columns.begin())];
        }
        text += "," + row.back + (withTruth ? "," + row.truth : std::string()) + "\r\n";
    }
    return text;
}

} // namespace agv::app
