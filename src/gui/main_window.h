// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>

#include "core/anchor_survey.h"
#include "core/plant_layout.h"
#include "core/serial_choice.h"
#include "core/snapshot.h"
#include "core/turn.h"

#include <memory>
#include <optional>
#include <vector>

namespace agv::gui {

/// The operator's window. Knows snapshots and requests only; the application wires them to the session.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(const PlantLayout& plant, QWidget* parent = nullptr);
    ~MainWindow() override;

public slots:
    void showSnapshot(const agv::PlantSnapshot& snapshot);
    void addEvent(const agv::EventEntry& event);
    /// Robots cannot connect; stays on the screen until showListening().
    void showListenFailure(const QString& reason);
    void showListening();
    /// Where the sleeptime of turnTimeApplied() went: into the log and onto the AGV's result. Plain English.
    void showTurnTimeKept(int robot, agv::EventLevel level, const QString& sentence);
    /// The simulated plant is gone for good.
    void showSimulationEnd(const QString& reason);

    /// Answers importUwbRequested(): what the file holds, as one edit that can be undone; `notes` are plain
    /// English.
    void takeImportedUwb(const std::vector<agv::UwbAnchor>& anchors, const agv::UwbSettings& settings,
                         const QStringList& notes);
    /// False: this plant has no file, so edits of the UWB kit hold for this session, and the window says so
    /// instead of asking. At first true.
    void setUwbSavable(bool savable);
    /// Answers saveUwbRequested(): where it went, or why it was not saved and what to do. Plain English.
    void showUwbSaved(bool saved, const QString& sentence);
    /// What became of an import that failed, or of an export. Plain English.
    void showUwbNote(agv::EventLevel level, const QString& sentence);
    /// Answers surveyAnchorsRequested().
    void showAnchorSurvey(const agv::AnchorSurvey& survey);
    /// Answers serialPortsRequested().
    void showSerialPorts(const std::vector<agv::SerialPortInfo>& ports);

signals:
    void acknowledgeAlarmsRequested(const std::vector<agv::AlarmKey>& keys);
    void shelveAlarmsRequested(const std::vector<agv::AlarmKey>& keys, double seconds);
    void unshelveAlarmsRequested(const std::vector<agv::AlarmKey>& keys);
    void openReaderRequested(int robot);
    void openUwbRequested();
    void closeUwbRequested();
    void closeReaderRequested(int robot);
    void startTurnRequested(int robot, const agv::TurnParameters& parameters);
    void abortTurnRequested(int robot);
    void retakeStopRequested(int robot, int stop); ///< 0-based
    void turnTimeChanged(int robot, double seconds);
    void turnSpeedChanged(int robot, double metresPerSecond);
    /// Besides turnTimeChanged(): it is to be kept, as the time of this wheel speed.
    void turnTimeApplied(int robot, double seconds, double metresPerSecond);
    void stopAllRequested();
    /// Driving by hand: once per press, "still held" every 50 ms, once when it ends.
    void jogPressed(int robot, const agv::JogCommand& command);
    void jogHeld(int robot, const agv::JogCommand& command);
    void jogReleased(int robot, const agv::JogCommand& command, agv::JogReason why);
    void stopRequested(int robot);
    void dockRequested(int robot, agv::DockOrder order);
    void stopAllReleased(); ///< hands may drive again after Stop all
    /// A trainer's command for the simulated plant (docs/simulated-plant.md).
    void simulationCommandRequested(const QString& command);

    /// The operator edited, undid, redid, imported: this holds from now on.
    void uwbEdited(const std::vector<agv::UwbAnchor>& anchors, const agv::UwbSettings& settings);
    void importUwbRequested(const QString& path);
    void exportUwbRequested(const QString& path, const std::vector<agv::UwbAnchor>& anchors,
                            const agv::UwbSettings& settings);
    /// Into the plant file; answered by showUwbSaved().
    void saveUwbRequested(const std::vector<agv::UwbAnchor>& anchors, const agv::UwbSettings& settings);
    /// The tag stands at this point (plant frame, m); its progress is in UwbSnapshot::calibration.
    void startRangeCalibrationRequested(int tag, double x_m, double y_m, double z_m, double seconds);
    void cancelRangeCalibrationRequested();
    void surveyAnchorsRequested(); ///< answered by showAnchorSurvey()
    void serialPortsRequested();   ///< answered by showSerialPorts()
    /// Besides uwbEdited(), which carries the choice too.
    void uwbPortChosen(const agv::SerialPortChoice& port, std::optional<agv::UwbDialect> dialect);
    void
    askUwbRequested(); ///< ask the unit for its version and configuration; the answer is in UwbSnapshot::unit

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace agv::gui
