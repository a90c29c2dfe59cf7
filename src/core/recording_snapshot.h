// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace agv {

enum class RecordingState {
    Off,
    Recording,
    Failed, ///< it stopped by itself; RecordingSnapshot::reason says why
};

/// What is being recorded.
struct RecordingSnapshot {
    RecordingState state = RecordingState::Off;
    std::string folder;      ///< of the run, or of the last one; empty: none yet
    std::uint64_t bytes = 0; ///< on the disk
    double elapsed_s = 0.0;  ///< since the run began
    std::string reason;      ///< Failed: why, and what to do; plain English
    bool canKeep = false;    ///< the last minutes can be kept as a run
    friend bool operator==(const RecordingSnapshot&, const RecordingSnapshot&) = default;
};

} // namespace agv
