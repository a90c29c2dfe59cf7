// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/snapshot.h"

#include <vector>

namespace agv::model {

/// One row per AGV: battery and what the robot says it does. GUI thread. Values of a robot that is
/// not connected are shown as missing, never as the last known ones.
class VehicleTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Vehicle, Battery, Charge, State, ColumnCount };
    enum Role {
        RobotRole = Qt::UserRole, ///< int, number of the AGV
        WarningRole,              ///< bool, the cell needs attention
    };

    explicit VehicleTableModel(QObject* parent = nullptr);

    void setSnapshot(const PlantSnapshot& snapshot);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        int robot = 0;
        std::string name;
        bool connected = false;
        bool mayBeMoving = false;
        std::optional<BatteryStatus> battery;
        std::optional<RobotState> state;
        friend bool operator==(const Row&, const Row&) = default;
    };
    static QString text(const Row& row, int column);
    static QString toolTip(const Row& row);
    static bool needsAttention(const Row& row, int column);

    std::vector<Row> m_rows;
};

} // namespace agv::model
