// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace agv::recording {

/// What is wrong with one line of a file, for people.
struct FileProblem {
    int line = 0;       ///< 1-based
    std::string reason; ///< plain English, what and what was expected
};

/// The problems of a file that was read all the same. A broken file may have one in every line: the first
/// hundred are kept, all are counted.
class FileProblems {
public:
    static constexpr std::size_t mostKept = 100;

    void add(int line, std::string reason)
    {
        if (m_count++ < mostKept)
            m_kept.push_back({line, std::move(reason)});
    }
    std::size_t count() const { return m_count; }
    bool empty() const { return m_count == 0; }
    const std::vector<FileProblem>& kept() const { return m_kept; }

private:
    std::vector<FileProblem> m_kept;
    std::size_t m_count = 0;
};

/// "ranges.csv:12: reason"
inline std::string problemText(std::string_view name, const FileProblem& problem)
{
    return std::string(name) + ":" + std::to_string(problem.line) + ": " + problem.reason;
}

} // namespace agv::recording
