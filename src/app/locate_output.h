// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/locate_run.h"
#include "estimation/error_metrics.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace agv::app {

/// A report with what a method and the truth say of it.
struct Outcome {
    const UwbReport& report;
    const ReportFix& fix;
    std::optional<TrueAt> truth;
};

/// Errors of one file and method.
class ErrorRow {
public:
    /// In space: the errors of the position count the height when the truth has it. Without a truth to
    /// compare with, n counts all positions.
    ErrorRow(bool inSpace, bool hasTruth) : m_inSpace(inSpace), m_hasTruth(hasTruth) {}
    void add(const Outcome& outcome);
    std::size_t fixes() const { return m_fixes; }

    /// Titles of the columns of cells().
    static std::vector<std::string> titles(bool inSpace);
    /// n, bias, least, mean, RMSE, median, CE50, CE75, CE95, greatest (mm); availability (%), rate (Hz);
    /// "-" for what is not known.
    std::vector<std::string> cells() const;

private:
    struct Span {
        double first_s = 0.0;
        double last_s = 0.0;
        std::size_t fixes = 0;
    };
    void addError(const Eigen::Vector3d& error);
    std::string rate() const;

    bool m_inSpace;
    bool m_hasTruth;
    std::size_t m_reports = 0;
    std::size_t m_fixes = 0;
    std::map<std::size_t, Span> m_spans; ///< by track
    estimation::ErrorSample m_position;
    estimation::ErrorSample m_circular; ///< in the plane
    Eigen::Vector3d m_sum = Eigen::Vector3d::Zero();
};

/// A table in columns of equal width.
class TextTable {
public:
    void add(std::vector<std::string> cells) { m_rows.push_back(std::move(cells)); }
    /// The first `left` columns to the left, the others to the right.
    std::string text(std::size_t left) const;

private:
    std::vector<std::vector<std::string>> m_rows;
};

/// Positions as CSV: file, method, the columns the range tables carry through, t_s, tag, status, position and
/// standard deviations in m, heading in degrees, ranges, rejected, and the truth.
class PositionCsv {
public:
    void add(const std::string& file, std::string_view method, const recording::RangeTable& table,
             const Outcome& outcome);
    /// Columns of every file added; empty where a file does not have one.
    std::string text(bool withTruth) const;

private:
    struct Row {
        std::string front;
        std::size_t columns = 0; ///< of m_columnSets
        std::vector<std::string> extras;
        std::string back;
        std::string truth;
    };
    std::vector<std::vector<std::string>> m_columnSets;
    std::vector<Row> m_rows;
};

/// What a report says in a column of its table; values that differ are parted by blanks.
std::string valueOf(const recording::RangeTable& table, const UwbReport& report, std::size_t column);

} // namespace agv::app
