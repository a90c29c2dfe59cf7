// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzz/fuzz_support.h"
#include "recording/file_problem.h"
#include "recording/text_lines.h"

#include <string>
#include <string_view>

namespace agv::fuzz {

/// Problems are counted, and each that is kept names a line of the file and has a reason.
inline void checkProblems(const recording::FileProblems& problems, std::string_view text)
{
    const int lines = static_cast<int>(recording::linesOf(text).size());
    require(problems.kept().size() <= problems.count(), "problems are counted");
    for (const recording::FileProblem& problem : problems.kept())
        require(problem.line >= 1 && problem.line <= lines && !problem.reason.empty(),
                "a problem names a line and has a reason");
}

/// Reads a table, and again with one row more that has a single field and means nothing: that row is one
/// problem and changes nothing else. `check` takes the table, `isSame` two tables without their problems.
template<typename Read, typename Check, typename Same>
void checkTableReader(std::string_view text, Read read, Check check, Same isSame)
{
    const auto table = read(text);
    const auto longer = read(std::string(text) + "\nx\n");
    require(table.has_value() == longer.has_value(), "a bad row decides nothing");
    if (!table) {
        require(!table.error().detail.empty(), "an error says what is wrong");
        return;
    }
    checkProblems(table->problems, text);
    check(*table);
    require(longer->problems.count() == table->problems.count() + 1, "a bad row is one problem");
    require(isSame(*table, *longer), "a bad row changes no other row");
}

} // namespace agv::fuzz
