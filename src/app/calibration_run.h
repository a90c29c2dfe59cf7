// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "app/progress_line.h"
#include "app/simulated_plant.h"
#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "recording/capture_writer.h"
#include "session/session.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace agv::app {

/// What came of one AGV.
struct CalibrationOutcome {
    int robot = 0;
    std::string label; ///< "AGV 1"
    TurnSnapshot turn;
    std::string problem; ///< why there was no turn; empty: there was one
    std::string capture; ///< text of the raw capture
    double turnTime_s = 0.0;
    std::optional<TruePose> truth; ///< of a simulated AGV, after the turn
};

/// The turn of one AGV: what was not asked for is the plant file's. Its sleeptime holds at its turn speed; at
/// another one a turn of 45 degrees takes the longer, the slower the wheels are.
TurnParameters parametersFor(const AgvConfig& agv, const CalibrateArguments& arguments);

/// Calibrates AGVs one after the other over a running session: opens the reader, waits for both links, turns,
/// asks the simulated plant for the truth. Lives in the main thread.
class CalibrationRun : public QObject {
    Q_OBJECT
public:
    /// Longest wait for a robot and its reader to be connected.
    static constexpr std::chrono::seconds linkTimeout{30};

    /// `simulated` may be null. All outlive this object.
    CalibrationRun(session::Session& session, SimulatedPlant* simulated, std::vector<AgvConfig> agvs,
                   const CalibrateArguments& arguments, ProgressLine& progress);

    void start();
    /// The run is over; what is missing has this problem.
    void giveUp(const std::string& problem);
    bool isBusy() const { return m_step != Step::Done; }
    const std::vector<CalibrationOutcome>& outcomes() const { return m_outcomes; }

signals:
    void outcomeKnown(const agv::app::CalibrationOutcome& outcome);
    void finished();

private:
    enum class Step { Links, Turn, Truth, Done };
    void next();
    void onSnapshot(const PlantSnapshot& snapshot);
    void onBytes(int robot, const QByteArray& bytes, Time time);
    void onPhase(int robot, TurnPhase phase, int stop, Time time);
    void onTurnEnded(int robot, const TurnSnapshot& turn);
    void onTimeout();
    void beginTurn();
    void takeCaptureLine(std::string_view text);
    std::string captureText() const;
    void conclude();
    const AgvConfig& agv() const { return m_agvs[m_index]; }

    session::Session& m_session;
    SimulatedPlant* m_simulated;
    std::vector<AgvConfig> m_agvs;
    CalibrateArguments m_arguments;
    ProgressLine& m_progress;
    QTimer m_timer;
    Step m_step = Step::Done;
    std::size_t m_index = 0;
    TurnParameters m_parameters;
    CalibrationOutcome m_current;
    std::vector<CalibrationOutcome> m_outcomes;
    std::string m_linkTrouble;
    std::optional<Time> m_linkedSince;
    std::optional<recording::CaptureWriter> m_capture;
    /// By ms since the beginning: a line may end after the mark that follows its first byte.
    std::multimap<double, std::string> m_captureLines;
    Time m_captureBegin;
    Time m_markTime;
};

} // namespace agv::app
