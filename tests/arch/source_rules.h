// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace agv::arch {

/// What a module may include beside itself, and whether it may include Qt. docs/ARCHITECTURE.md has the same
/// table for people.
struct ModuleRule {
    std::set<std::string> mayUse;
    bool qt = false;
};
using ModuleRules = std::map<std::string, ModuleRule>;

/// The modules of src.
const ModuleRules& moduleRules();

/// The names of modules in a circle of mayUse; empty when the arrows only point down.
std::vector<std::string> findCycle(const ModuleRules& rules);

/// A broken rule, at a line of a file (1-based; 1 for rules about the whole file).
struct Violation {
    std::string file; ///< relative to the scanned root, with '/'
    std::size_t line = 0;
    std::string problem;
    friend auto operator<=>(const Violation&, const Violation&) = default;
};
/// "src/core/ids.h:3: ..."
std::string toText(const Violation& violation);

inline constexpr std::size_t maxFileLines = 400;

/// Rules of every C++ file below `root`: licence on the first line, at most maxFileLines, #pragma once in
/// headers, snake_case names. Folders called "fixtures" are left out. Sorted by file and line.
std::vector<Violation> checkFiles(const std::filesystem::path& root);

/// Rules of the includes below `root`, which holds one folder per module: only allowed modules, no Qt in
/// Qt-free ones, no umbrella headers such as <QtWidgets>, Qt first in a header that moc reads.
std::vector<Violation> checkIncludes(const std::filesystem::path& root, const ModuleRules& rules);

} // namespace agv::arch
