// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"
#include "recording/range_file.h"

#include <cstddef>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace agv::app {

/// Anchors by the order of their list, which is AnchorRange::index.
struct AnchorSet {
    std::vector<UwbAnchor> anchors;
    std::map<std::pair<int, int>, double> corrections_m; ///< (tag, anchor id) -> added to the range, m

    std::optional<int> indexOf(int id) const;
};

/// Anchors of a table (recording/anchor_csv.h) or of TREKanc_config.xml, told from the content. Errors name
/// the file and the line; anchors of the XML that are left out are named on `err`.
Result<AnchorSet> readAnchorFile(const std::string& path, std::ostream& err);

/// Anchors of a plant file; BadInput when it has none.
Result<AnchorSet> readPlantAnchors(const std::string& path);

/// The ranges of a file of any format of recording/range_file.h; "-" is `in`. Errors name file and line.
Result<recording::RangeFile> readRanges(const std::string& path, std::istream& in);

/// The files themselves, and for a folder (a run of the console) those files in it that hold ranges, by name.
/// NotFound when a folder has none.
Result<std::vector<std::string>> filesOf(const std::string& input);

/// Names problems on `err`, and how many more there are.
void report(const std::string& path, const recording::FileProblems& problems, std::ostream& err);

/// "PATH: reason", or "PATH:LINE: reason" when the reason begins with a line.
Error inFile(const std::string& path, Error error);

} // namespace agv::app
