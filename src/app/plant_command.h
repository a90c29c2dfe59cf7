// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace agv::app {

enum class PlantAction { Check, ExportTags, ImportTags };

/// What `agv-console plant` was asked for.
struct PlantArguments {
    PlantAction action = PlantAction::Check;
    std::vector<std::string> plantFiles; ///< one or more for Check, otherwise exactly one
    std::string csvFile;                 ///< ImportTags: the table of surveyed tags
    std::optional<std::string> outFile;  ///< --out; empty: standard output, or the plant file itself
    bool merge = false;                  ///< --merge: tags that are not in the table stay
};

/// Checks plant files, writes their floor tags as a table, or takes a table of surveyed tags over into a
/// plant file, which keeps everything else. Results go to `out`; warnings, and errors as
/// "FILE:LINE:COLUMN: /key: reason", to `err`. Returns the exit status: 0, or 1 when something was wrong;
/// then no file has changed, unless only standard output could not be written.
int runPlant(const PlantArguments& arguments, std::ostream& out, std::ostream& err);

} // namespace agv::app
