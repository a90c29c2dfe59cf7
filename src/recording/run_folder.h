// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace agv::recording {

// A run is a folder with these files.
inline constexpr const char* runInfoFile = "run.json";
inline constexpr const char* runPlantFile = "plant.json"; ///< as used; can be given as --plant
inline constexpr const char* runDatabaseFile = "run.sqlite";
inline constexpr const char* runLockFile = "run.lock"; ///< held by the console that writes the run

inline constexpr int runFormat = 1; ///< raised when older programs can no longer read a run

/// What run.json says of a run.
struct RunInfo {
    int format = runFormat;
    std::string software;                     ///< "agv-console 0.1.0"
    std::int64_t started_utc_ms = 0;          ///< milliseconds since 1970
    std::optional<std::int64_t> ended_utc_ms; ///< empty: it runs, or the console ended in the middle
    std::string startedBy;                    ///< "operator", "turn", "always on", "kept"
    std::string note;                         ///< the operator's
    std::string plantName;
    std::string plantFile; ///< where the plant came from; empty: built in
    std::vector<int> agvs;
    bool simulated = false;
    std::uint64_t solverSeed = 1;
    std::string solver; ///< SolveMethod as a word
};

/// Reads run.json of a run. NotFound, Permission, Io, or BadInput with the place that is wrong.
Result<RunInfo> readRunInfo(const std::filesystem::path& run);
/// Replaces it as a whole.
Result<void> writeRunInfo(const std::filesystem::path& run, const RunInfo& info);

/// "2026-03-17T15:30:05.123Z"
std::string utcText(std::int64_t utc_ms);
/// "20260317T153005Z", the name of a run that began then.
std::string runName(std::int64_t utc_ms);

/// Makes a new folder for a run in `parent`, which is made when missing: `name`, or name-2, name-3, ... where
/// there is one already, so that two consoles never share one. Permission or Io says what is in the way.
Result<std::filesystem::path> makeRunFolder(const std::filesystem::path& parent, const std::string& name);

/// Held while a run is written; the system lets go of it when the process ends, however it ends.
class RunLock {
public:
    /// InUse when another console, or this one, holds it.
    static Result<RunLock> take(const std::filesystem::path& run);
    RunLock(RunLock&& other) noexcept : m_descriptor(other.m_descriptor) { other.m_descriptor = -1; }
    RunLock& operator=(RunLock&& other) noexcept;
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;
    ~RunLock();

private:
    explicit RunLock(int descriptor) : m_descriptor(descriptor) {}
    int m_descriptor;
};

} // namespace agv::recording
