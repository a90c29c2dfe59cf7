// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/jog.h"
#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "gui/theme.h"

#include <memory>

namespace Ui {
class JogPanel;
}

namespace agv::gui {

class JogHold;
class JogPad;

/// Driving the chosen AGV by hand: pad, speed, docks, and a sentence that says what drives or why nothing
/// does. What the hand holds goes out as signals; the session decides what becomes of it, and says so in
/// AgvSnapshot::jog.
class JogPanel : public QWidget {
    Q_OBJECT
public:
    explicit JogPanel(QWidget* parent = nullptr);
    ~JogPanel() override;

    void setPlant(const PlantLayout& plant);
    void setTheme(const Theme& theme);
    void showSnapshot(const PlantSnapshot& snapshot);
    int robot() const; ///< the chosen AGV, 0 when the plant has none
    JogPad* pad() const;

public slots:
    /// Ends a hold of another AGV.
    void setRobot(int robot);
    /// Of its dock, which does not hide when it lies behind another one.
    void setSeen(bool seen);

signals:
    void robotChosen(int robot);
    void pressed(int robot, const agv::JogCommand& command);
    void held(int robot, const agv::JogCommand& command);
    void released(int robot, const agv::JogCommand& command, agv::JogReason why);
    void stopRequested(int robot);
    void dockRequested(int robot, agv::DockOrder order);
    void stopAllReleased();

protected:
    void changeEvent(QEvent* event) override;

private:
    void connectPad();
    void connectRest();
    void press(JogSource source, JogDirection direction);
    void onRobotChosen();
    double speed_m_s() const;
    void updateSpeed();
    void showState();
    void setSentence(const QString& text, bool isWarning);
    QString sentence(const AgvSnapshot& agv) const;
    const AgvSnapshot* current() const;
    void retranslate();

    std::unique_ptr<Ui::JogPanel> m_ui;
    JogHold* m_hold;
    PlantLayout m_plant;
    PlantSnapshot m_snapshot;
    JogDirection m_direction;
    int m_heldRobot = 0;  ///< of the hold; the choice may have changed since
    QString m_ownRefusal; ///< what this window did not even send, until the next press
};

} // namespace agv::gui
