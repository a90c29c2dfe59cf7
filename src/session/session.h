// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>

#include "core/anchor_survey.h"
#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "core/turn.h"
#include "link/connection_guard.h"
#include "procedure/range_calibration.h"
#include "session/run_recorder.h"
#include "session/uwb_link.h"

#include <memory>
#include <vector>

namespace agv::session {

class AlarmDesk;
class JogDesk;

struct SessionOptions {
    bool simulated = false; ///< shown on every screen
    std::uint64_t solverSeed = 1;
    SolveMethod method = SolveMethod::Auto;
    link::ConnectionGuard* guard = nullptr; ///< of the robots' connections; may be null, outlives the session
    UwbLinkParameters uwb = {};
    RecordingOptions recording = {};
};

/// The straight line from bytes to snapshots for a whole plant: links, decoders, procedures, solvers. Lives
/// in the session thread; everything crosses its boundary as queued values. Never blocks, never shows
/// anything. On destruction every robot that is connected has been sent zero wheel speed.
class Session : public QObject {
    Q_OBJECT
public:
    Session(PlantLayout plant, SessionOptions options, QObject* parent = nullptr);
    ~Session() override;

    /// What operators say of alarms goes there, queued.
    AlarmDesk& alarms();

    /// Driving by hand.
    JogDesk* jogDesk() const;

public slots:
    /// Listens for robots and telemetry; emits listening() or an Error event that says why not. A port that
    /// another program holds is tried again every two seconds.
    void start();
    void openReader(int robot);
    void closeReader(int robot);
    /// Another address for a reader than the plant file's; an open link is made anew.
    void setReaderEndpoint(int robot, const QString& host, quint16 port);
    // The UWB unit. While the plant has no UWB anchors there is none; one that was opened comes to life with
    // the first anchors.
    void openUwb();
    void closeUwb();
    /// Another port than the plant file's, for this session; an open link is made anew.
    void setUwbPort(const agv::SerialPortChoice& port);
    /// Finds where the anchors stand from the ranges between them that were heard last; anchorsSurveyed()
    /// answers at once.
    void surveyAnchors();
    /// Asks the unit for its version and configuration even when it is a clone.
    void askUwb();
    /// The edited plant's; holds at once and does not touch the port, unless `settings` names another.
    void setUwb(const std::vector<agv::UwbAnchor>& anchors, const agv::UwbSettings& settings);
    /// Finds what is to be added to the ranges of a tag that stands at (x, y, z), plant frame, m; the result
    /// is in UwbSnapshot::calibration. `seconds`: 1 to 600.
    void startRangeCalibration(int tag, double x, double y, double z,
                               double seconds = procedure::RangeCalibration::usualDuration_s);
    void cancelRangeCalibration();
    /// Ignored with a Warning event when the robot or its reader is not up, or a turn is running.
    void startTurn(int robot, const agv::TurnParameters& parameters);
    void abortTurn(int robot, const QString& reason);
    void retakeStop(int robot, int stop);                 ///< 0-based
    void setTurnTime(int robot, double seconds);          ///< sleeptime used for the next turns
    void setTurnSpeed(int robot, double metresPerSecond); ///< their wheel speed
    /// Zero speed to every robot, every procedure aborted; several times. Never refused.
    void stopAll(const QString& reason);
    // Recording. What becomes of it is in PlantSnapshot::recording and in the event log; trouble with the
    // disk stops the recording and nothing else.
    void startRun(const QString& note = {}); ///< nothing happens while one runs
    void stopRun();
    void keepRecent(); ///< the last ten minutes, as a run of their own
    /// Into the event log, as the console's own.
    void warn(const QString& text);

signals:
    /// Once, as soon as robots can connect. `telemetryPort` is 0 when that port could not be opened.
    void listening(quint16 robotPort, quint16 telemetryPort);
    /// The Error event that says why was logged just before; robots cannot connect for now.
    void listenFailed(const QString& reason);
    void snapshotReady(const agv::PlantSnapshot& snapshot); ///< 30 per second at most
    void eventLogged(const agv::EventEntry& event);
    /// Once per turn and per retake, whatever its end; `turn.result` is set when it was solved.
    void turnEnded(int robot, const agv::TurnSnapshot& turn, std::shared_ptr<const agv::TurnRecord> record);
    /// startTurn() did not start one; the Warning event says the same.
    void turnRefused(int robot, const QString& reason);
    /// Once for each surveyAnchors(); AnchorSurvey::trouble says why there are no places.
    void anchorsSurveyed(const agv::AnchorSurvey& survey);
    /// Every byte of a reader with the monotonic time of its arrival; for recordings.
    void readerBytes(int robot, const QByteArray& bytes, agv::Time time);
    /// Every byte of the UWB unit with the monotonic time of its arrival; for recordings.
    void uwbBytes(const QByteArray& bytes, agv::Time time);
    /// The turn of a robot went on; `stop` is 1-based. For recordings, in order with readerBytes().
    void turnPhaseChanged(int robot, agv::TurnPhase phase, int stop, agv::Time time);

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace agv::session
