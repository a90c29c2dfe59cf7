// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "core/snapshot.h"
#include "gui/theme.h"
#include "model/range_calibration_model.h"

#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QMenu;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace agv::gui {

class HintTableView;
class UwbEditor;

/// Finds the range corrections of one tag that stands at a known point: choose, collect, look, accept or
/// discard. Accepting is one edit. The collecting itself is done below; its progress comes with the
/// snapshots.
class RangeCalibrationDialog : public QDialog {
    Q_OBJECT
public:
    RangeCalibrationDialog(const PlantLayout& plant, UwbEditor& editor, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void showSnapshot(const PlantSnapshot& snapshot);
    /// Closing gives up a collection that is running.
    void done(int result) override;

signals:
    /// Plant frame, m.
    void startRequested(int tag, double x_m, double y_m, double z_m, double seconds);
    void cancelRequested();

private:
    enum class Phase { Choosing, Asked, Collecting, Finished, Failed };

    void buildForm();
    void buildResult();
    void start();
    void accept() override;
    void fillTags();
    void fillAgvMenu();
    void onTagChosen();
    void takeAgv(RobotId id);
    void takeFloorTag();
    void setPoint(Point2 point);
    void setPhase(Phase phase);
    void follow(const RangeCalibrationSnapshot& calibration);
    void showStatus();
    /// Why collecting cannot start now; empty: it can.
    QString obstacle() const;
    int chosenTag() const;
    QString nameOf(int tag) const;

    PlantLayout m_plant;
    UwbEditor& m_editor;
    PlantSnapshot m_snapshot;
    RangeCalibrationSnapshot m_before; ///< what the snapshot said when collecting was asked for
    RangeCalibrationSnapshot m_result;
    model::RangeCalibrationModel m_model;
    Theme m_theme = Theme::light();
    Phase m_phase = Phase::Choosing;
    int m_waited = 0;    ///< snapshots since then
    QString m_pointNote; ///< what is wrong with the floor tag that was typed
    QComboBox* m_tag = nullptr;
    QDoubleSpinBox* m_x = nullptr;
    QDoubleSpinBox* m_y = nullptr;
    QDoubleSpinBox* m_z = nullptr;
    QSpinBox* m_seconds = nullptr;
    QLineEdit* m_floorTag = nullptr;
    QPushButton* m_useFloorTag = nullptr;
    QPushButton* m_useAgv = nullptr;
    QMenu* m_agvMenu = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_accept = nullptr;
    QPushButton* m_discard = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_statusIcon = nullptr;
    QLabel* m_status = nullptr;
    HintTableView* m_table = nullptr;
};

} // namespace agv::gui
