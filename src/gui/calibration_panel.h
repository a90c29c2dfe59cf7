// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "core/turn.h"
#include "gui/theme.h"
#include "model/stop_table_model.h"

#include <memory>

namespace Ui {
class CalibrationPanel;
}

namespace agv::gui {

/// Everything of the initialisation turn of the chosen AGV: what to set, the press, the progress by stop, the
/// verdict in words, the table of stops. Holds no state of its own besides what the operator typed.
class CalibrationPanel : public QWidget {
    Q_OBJECT
public:
    explicit CalibrationPanel(QWidget* parent = nullptr);
    ~CalibrationPanel() override;

    void setPlant(const PlantLayout& plant);
    void setTheme(const Theme& theme);
    void showSnapshot(const PlantSnapshot& snapshot);
    /// Where the sleeptime that was applied last to this AGV is kept.
    void showKept(int robot, const QString& sentence);

    int robot() const; ///< the chosen AGV, 0 when the plant has none
    QString robotName() const;
    TurnParameters parameters() const;
    bool canStart() const;
    bool canAbort() const;

public slots:
    void setRobot(int robot);
    void initialise();
    void abort();
    void copyTable() const;

signals:
    void robotChosen(int robot);
    void startTurnRequested(int robot, const agv::TurnParameters& parameters);
    void abortTurnRequested(int robot);
    void retakeStopRequested(int robot, int stop); ///< 0-based
    void turnTimeChanged(int robot, double seconds);
    void turnSpeedChanged(int robot, double metresPerSecond);
    /// Besides turnTimeChanged(): it is to be kept, as the time of this wheel speed.
    void turnTimeApplied(int robot, double seconds, double metresPerSecond);
    void actionsChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Settings {
        int robot = 0;
        double turnTime_s = 0.0;
        double turnSpeed_m_s = 0.0;
    };
    void connectWidgets();
    void showRobot();
    void showSettings(const AgvSnapshot& agv);
    void showTurnSpeed(double metresPerSecond);
    void showPhase(const AgvSnapshot& agv);
    void showPreview(const TurnSnapshot& turn);
    void updateActions();
    void applyTurnTime(int robot, double seconds);
    void retake();
    void sendTurnTime();
    /// The sleeptime goes with it, so that the steps keep their size.
    void sendTurnSpeed();
    void retranslate();
    QString obstacleToStart(const AgvSnapshot& agv) const;
    QString nameOf(const AgvSnapshot& agv) const;
    const AgvSnapshot* current() const;

    std::unique_ptr<Ui::CalibrationPanel> m_ui;
    Theme m_theme = Theme::light();
    PlantLayout m_plant;
    PlantSnapshot m_snapshot;
    model::StopTableModel m_stops;
    Settings m_shown;                ///< as last received: only news overwrite the fields
    int m_speedOfSleeptime_mm_s = 0; ///< the wheel speed that the sleeptime in the field is for
};

} // namespace agv::gui
