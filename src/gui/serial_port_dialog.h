// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "core/serial_choice.h"
#include "core/uwb_snapshot.h"
#include "gui/theme.h"

#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStandardItemModel;

namespace agv::gui {

class HintTableView;

/// Chooses the serial port of the UWB unit and how the unit writes. Units of the kit stand first; "any
/// TREK1000 unit" finds the unit again after it was plugged in elsewhere.
class SerialPortDialog : public QDialog {
    Q_OBJECT
public:
    SerialPortDialog(const SerialPortChoice& port, std::optional<UwbDialect> dialect,
                     QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void showPorts(std::vector<SerialPortInfo> ports);
    /// Null: nothing is known of the unit.
    void showUwb(const UwbSnapshot* uwb);
    /// What Use would choose.
    SerialPortChoice choice() const;
    std::optional<UwbDialect> dialect() const;

signals:
    void portsRequested();
    void askRequested();
    void chosen(const agv::SerialPortChoice& port, std::optional<agv::UwbDialect> dialect);

private:
    void buildFields();
    void accept() override;
    void fillPorts();
    void onRowChosen();
    QString unitText(const UwbSnapshot* uwb) const;

    SerialPortChoice m_present;
    std::vector<SerialPortInfo> m_ports;
    Theme m_theme = Theme::light();
    QStandardItemModel* m_model;
    HintTableView* m_table;
    QLineEdit* m_path;
    QComboBox* m_dialect;
    QLabel* m_none; ///< shown when the computer has no serial port
    QLabel* m_unit;
    QPushButton* m_ask;
    QPushButton* m_use;
};

} // namespace agv::gui
