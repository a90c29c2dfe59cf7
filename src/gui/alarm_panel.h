// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/snapshot.h"
#include "gui/theme.h"
#include "model/alarm_table_model.h"

#include <memory>
#include <vector>

namespace Ui {
class AlarmPanel;
}

namespace agv::gui {

/// The list of alarms, with what an operator says of them. GUI thread.
class AlarmPanel : public QWidget {
    Q_OBJECT
public:
    explicit AlarmPanel(QWidget* parent = nullptr);
    ~AlarmPanel() override;

    void setTheme(const Theme& theme);
    void showSnapshot(const PlantSnapshot& snapshot);
    const model::AlarmTableModel& alarms() const { return m_alarms; }

public slots:
    /// The chosen ones; with none chosen, all that are new.
    void acknowledge();

signals:
    void acknowledgeRequested(const std::vector<agv::AlarmKey>& keys);
    void shelveRequested(const std::vector<agv::AlarmKey>& keys, double seconds);
    void unshelveRequested(const std::vector<agv::AlarmKey>& keys);
    /// More alarms are new than before.
    void alarmCame();

protected:
    void changeEvent(QEvent* event) override;
    QSize sizeHint() const override { return {600, 180}; }

private:
    void buildShelfMenu();
    void updateButtons();
    void fitRows();
    std::vector<AlarmKey> chosen(bool (*fits)(const AlarmSnapshot&)) const;

    std::unique_ptr<Ui::AlarmPanel> m_ui;
    model::AlarmTableModel m_alarms;
    int m_newCount = 0;
};

} // namespace agv::gui
