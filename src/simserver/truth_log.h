// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "simulation/plant.h"

#include <filesystem>
#include <fstream>

namespace agv::simserver {

/// Writes where every AGV really was as CSV, 20 rows a second and AGV of the plant's own time.
class TruthLog {
public:
    /// Io: the file cannot be written, and why.
    static Result<TruthLog> open(const std::filesystem::path& path);

    /// Writes a row per AGV when 50 ms have passed since the last rows.
    void record(const simulation::Plant& plant);
    bool failed() const { return m_file.fail(); }

private:
    explicit TruthLog(std::ofstream file) : m_file(std::move(file)) {}

    std::ofstream m_file;
    Time m_next;
};

} // namespace agv::simserver
