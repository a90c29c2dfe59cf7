// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "core/plant_layout.h"
#include "recording/run_writer.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace agv::session {

/// Which run is to be begun.
struct RunOrder {
    std::filesystem::path runs; ///< folder of the runs
    recording::RunInfo info;
    PlantLayout plant;
    recording::ClockPair start;
};

/// Writes the runs. Lives in a thread of its own, where a slow disk makes nobody wait; the orders come from
/// RunRecorder as queued calls. Two runs at most: the one that was asked for, and the ring of the last hours,
/// which forgets what is older.
class RunStore : public QObject {
    Q_OBJECT
public:
    static constexpr const char* ringName = "recent";         ///< folder of the ring
    static constexpr const char* earlierRingName = "earlier"; ///< the ring of the console before

    void beginRun(const RunOrder& order);
    void endRun(std::int64_t ended_utc_ms);
    /// What an ended console left as its ring is put aside under earlierRingName.
    void beginRing(const RunOrder& order, Duration keptFor);
    /// Copies the ring from `since` on into a run of its own.
    void keep(const RunOrder& order, Time since);
    void append(const std::shared_ptr<const recording::RunBatch>& batch);

signals:
    void runBegan(const QString& folder);
    void runEnded(const QString& folder);
    /// What was recorded is there, but not its end.
    void endFailed(const QString& reason);
    /// It is over; what was written before stays. Plain English.
    void runFailed(const QString& reason);
    void ringBegan();
    void ringFailed(const QString& reason);
    void kept(const QString& folder);
    void keepFailed(const QString& reason);
    /// A batch of `batchBytes` (RunBatch::bytes) is on the disk or lost; `runBytes`: size of the run.
    void appended(quint64 batchBytes, quint64 runBytes);

private:
    void appendToRing(const recording::RunBatch& batch);
    static void putAside(const std::filesystem::path& runs);

    std::optional<recording::RunWriter> m_run;
    std::optional<recording::RunWriter> m_ring;
    Duration m_keptFor{};
    Time m_forgotten; ///< when the ring forgot last
};

} // namespace agv::session
