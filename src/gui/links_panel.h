// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/snapshot.h"
#include "gui/theme.h"
#include "model/link_table_model.h"
#include "model/vehicle_table_model.h"

#include <memory>

namespace Ui {
class LinksPanel;
}

namespace agv::gui {

/// Every connection with its state, address, rate and age; every AGV with its battery and state; the peers
/// that were refused. Opens and closes RFID readers
/// and the UWB unit.
class LinksPanel : public QWidget {
    Q_OBJECT
public:
    explicit LinksPanel(QWidget* parent = nullptr);
    ~LinksPanel() override;

    void setTheme(const Theme& theme);
    void showSnapshot(const PlantSnapshot& snapshot);
    const model::LinkTableModel& links() const { return m_links; }

signals:
    void openReaderRequested(int robot);
    void closeReaderRequested(int robot);
    void openUwbRequested();
    void closeUwbRequested();
    void uwbPortRequested(); ///< to be chosen

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void updateButtons();
    void read(bool on);
    void showReading();
    QString readingOf(const AgvSnapshot& agv) const;
    /// Robots whose reader is chosen; all when no row is.
    std::vector<int> chosenRobots() const;
    bool isUwbChosen() const; ///< and nothing else
    bool isChosen(const QModelIndex& row) const;

    std::unique_ptr<Ui::LinksPanel> m_ui;
    Theme m_theme = Theme::light();
    model::LinkTableModel m_links;
    model::VehicleTableModel m_vehicles;
    std::vector<std::string> m_refused;
    std::vector<AgvSnapshot> m_agvs;
};

} // namespace agv::gui
