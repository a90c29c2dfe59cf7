// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/run_reader.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace agv::recording {

struct CsvExport {
    std::uint64_t rows = 0;
    std::vector<std::filesystem::path> files;
};

/// Told how far it is, 0..1; false cancels.
using CsvProgress = std::function<bool(double fraction)>;

/// Writes a run as tables: one CSV file per kind of row, raw.csv with the bytes of the links, and run.json
/// (docs/manual/runs.md has the columns). `folder` is made when missing. The files appear with their names
/// when all are written and none did before; Cancelled, and every Error of reading or writing, leaves the
/// folder as it was.
///
/// UTF-8 without a byte order mark, comma, decimal point, CR LF, RFC 4180 quotes; a value that there is none
/// of is empty. Text that a spreadsheet would compute gets an apostrophe. Numbers are exact: read back, they
/// are what the run holds.
Result<CsvExport> exportCsv(RunReader& run, const std::filesystem::path& folder,
                            const CsvProgress& progress = {});

} // namespace agv::recording
