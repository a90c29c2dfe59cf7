// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QThread>
#include <QTimer>

#include "core/plant_layout.h"
#include "core/recording_snapshot.h"
#include "link/chunk.h"
#include "recording/run_rows.h"
#include "session/event_log.h"
#include "session/run_store.h"

#include <filesystem>
#include <memory>
#include <string>

namespace agv::session {

struct RecordingOptions {
    std::filesystem::path runs;                      ///< folder of the runs; empty: nothing can be recorded
    bool ring = false;                               ///< the last hours are always recorded
    Duration ringFor = std::chrono::hours(2);        ///< so long
    bool everyTurn = false;                          ///< each initialisation turn is recorded as a run
    std::string software = "agv-console";            ///< with its version
    std::string plantFile;                           ///< where the plant came from; empty: built in
    std::size_t mostPending = std::size_t{64} << 20; ///< bytes that may wait for the disk
};

/// Gathers what is to be recorded and hands it to the RunStore every half second, so that a crash costs no
/// more. Lives in the session thread and never waits for the disk; when that falls behind by mostPending
/// bytes the recording stops. Trouble stops the recording, is logged, and touches nothing else.
class RunRecorder : public QObject {
    Q_OBJECT
public:
    static constexpr std::chrono::milliseconds batchTime{500};
    static constexpr Duration keptMinutes = std::chrono::minutes(10); ///< by keepRecent()

    RunRecorder(RecordingOptions options, EventLog& events, QObject* parent);
    /// Ends the run and waits until it is on the disk.
    ~RunRecorder() override;

    /// The facts of the session that go into each run; from then on the ring runs.
    void begin(const PlantLayout& plant, bool simulated, std::uint64_t solverSeed, SolveMethod method);
    /// Of an edited plant; for the runs that begin from now on.
    void setPlant(const PlantLayout& plant) { m_plant = plant; }

    void start(const std::string& startedBy, const std::string& note);
    void stop();
    /// The last ten minutes as a run of their own; needs the ring.
    void keepRecent();

    /// Somebody writes what comes: the run or the ring.
    bool isListening() const { return m_isRunning || m_hasRing; }
    bool isRunning() const { return m_isRunning; }
    const RecordingOptions& options() const { return m_options; }
    void chunk(const std::string& link, const link::Chunk& chunk);
    void row(recording::RunRow row);

    RecordingSnapshot snapshot(Time now) const;

signals:
    void began(); ///< a run was ordered
    void changed();

private:
    RunOrder order(const std::string& startedBy, const std::string& note) const;
    void wireStore();
    void flush();
    void fail(const QString& reason);
    void log(EventLevel level, const QString& text);
    template<typename Call>
    void tell(Call call);

    RecordingOptions m_options;
    EventLog& m_events;
    PlantLayout m_plant;
    recording::RunInfo m_info;
    RunStore* m_store; ///< lives in m_thread
    QThread m_thread;
    QTimer* m_timer;
    recording::RunBatch m_batch;
    std::size_t m_pending = 0; ///< bytes that were handed over and are not on the disk
    bool m_isRunning = false;
    bool m_hasRing = false;
    Time m_started;
    RecordingSnapshot m_shown;
};

} // namespace agv::session
