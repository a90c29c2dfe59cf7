// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "core/turn.h"

#include <memory>

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

signals:
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
    /// A trainer's command for the simulated plant (docs/simulated-plant.md).
    void simulationCommandRequested(const QString& command);

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace agv::gui
