// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "gui/theme.h"
#include "model/shift_calibration.h"
#include "model/shift_checks.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace Ui {
class ShiftPanel;
}

namespace agv::gui {

/// The start of a shift: one button checks everything, another one calibrates the AGVs that can, one after
/// the other; the verdict goes into the event log. Moves nothing by itself: it asks for turns as the panel
/// *Calibration* does. GUI thread.
class ShiftPanel : public QWidget {
    Q_OBJECT
public:
    /// The checks look at the snapshots of that long; some things are only to be seen now and then.
    static constexpr Duration checkTime = std::chrono::seconds(3);

    explicit ShiftPanel(QWidget* parent = nullptr);
    ~ShiftPanel() override;

    void setPlant(const PlantLayout& plant);
    void setTheme(const Theme& theme);
    /// What the snapshot does not tell; asked when the checks begin.
    void setFactsSource(std::function<model::ShiftFacts()> facts) { m_facts = std::move(facts); }
    void showSnapshot(const PlantSnapshot& snapshot);

    bool isCalibrating() const { return m_calibration.isRunning(); }
    const std::vector<model::ShiftCheck>& checks() const { return m_checks; }

public slots:
    void check();
    void calibrate();
    /// By the operator, also by *Stop all*: no other turn is started. The one that runs is aborted.
    void stop();

signals:
    void turnWanted(int robot);
    void abortWanted(int robot);
    /// For the event log; in the language of the program.
    void verdictReached(bool good, const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void updateChecks();
    void endChecks();
    void updateCalibration();
    void endCalibration();
    void showChecks();
    void showTurns();
    void updateButtons();
    std::vector<int> readyRobots() const;
    std::vector<int> robotsIn(model::ShiftCalibration::Outcome outcome) const;

    std::unique_ptr<Ui::ShiftPanel> m_ui;
    Theme m_theme = Theme::light();
    PlantLayout m_plant;
    PlantSnapshot m_snapshot;
    std::function<model::ShiftFacts()> m_facts;
    std::vector<model::ShiftCheck> m_checks;
    std::optional<Time> m_checkingSince;
    model::ShiftCalibration m_calibration;
    bool m_wasCalibrating = false;
};

} // namespace agv::gui
