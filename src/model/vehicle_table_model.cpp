// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/vehicle_table_model.h"

#include "model/words.h"

#include <optional>

namespace agv::model {
namespace {

constexpr double lowCharge = 0.20; ///< below this a turn takes noticeably longer than its sleeptime

std::optional<double> chargeOf(const std::optional<BatteryStatus>& battery)
{
    if (!battery || battery->capacity_Ah <= 0.0)
        return {};
    return battery->charge_Ah / battery->capacity_Ah;
}

} // namespace

VehicleTableModel::VehicleTableModel(QObject* parent) : QAbstractTableModel(parent) {}

void VehicleTableModel::setSnapshot(const PlantSnapshot& snapshot)
{
    std::vector<Row> rows;
    rows.reserve(snapshot.agvs.size());
    for (const AgvSnapshot& agv : snapshot.agvs) {
        const bool connected = isConnected(agv.robotLink);
        rows.push_back({agv.id.number, agv.name, connected, agv.mayBeMoving,
                        connected ? agv.battery : std::nullopt, connected ? agv.robotState : std::nullopt});
    }
    if (rows.size() != m_rows.size()) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
        return;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i] == m_rows[i])
            continue;
        m_rows[i] = std::move(rows[i]);
        const int row = static_cast<int>(i);
        emit dataChanged(index(row, 0), index(row, ColumnCount - 1));
    }
}

int VehicleTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int VehicleTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString VehicleTableModel::text(const Row& row, int column)
{
    switch (column) {
    case Vehicle:
        return row.name.empty() ? tr("AGV %1").arg(row.robot) : QString::fromStdString(row.name);
    case Battery:
        return row.battery ? Words::volts(row.battery->voltage_V) : Words::none();
    case Charge: {
        const std::optional<double> charge = chargeOf(row.battery);
        return charge ? Words::percent(*charge) : Words::none();
    }
    case State:
        return row.mayBeMoving ? tr("May be moving") : Words::robotState(row.connected, row.state);
    default:
        return {};
    }
}

QString VehicleTableModel::toolTip(const Row& row)
{
    QStringList lines{text(row, Vehicle)};
    if (row.mayBeMoving)
        lines << tr("The connection was lost while the wheels were turning. Go and look before you drive.");
    if (row.battery) {
        lines << tr("Battery: %1, %2")
                     .arg(Words::volts(row.battery->voltage_V), Words::charging(row.battery->charging));
        lines << tr("Temperature: %1 °C").arg(row.battery->temperature_degC);
    } else if (row.connected) {
        lines << tr("The robot is connected but has not reported its battery yet.");
    } else {
        lines << tr("The robot has not connected. Switch it on; it connects by itself.");
    }
    return lines.join(QLatin1Char('\n'));
}

bool VehicleTableModel::needsAttention(const Row& row, int column)
{
    if (column == State)
        return row.mayBeMoving || row.state == RobotState::Error;
    if (column == Charge)
        return chargeOf(row.battery).value_or(1.0) < lowCharge;
    return column == Battery && row.battery && row.battery->charging == ChargingState::Fault;
}

QVariant VehicleTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return toolTip(row);
    case Qt::TextAlignmentRole: {
        const bool number = index.column() == Battery || index.column() == Charge;
        return QVariant::fromValue(
            Qt::Alignment(number ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter));
    }
    case RobotRole:
        return row.robot;
    case WarningRole:
        return needsAttention(row, index.column());
    default:
        return {};
    }
}

QVariant VehicleTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole) {
        const bool number = section == Battery || section == Charge;
        return QVariant::fromValue(
            Qt::Alignment(number ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter));
    }
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Vehicle:
        return tr("AGV");
    case Battery:
        return tr("Battery");
    case Charge:
        return tr("Charge");
    case State:
        return tr("State");
    default:
        return {};
    }
}

} // namespace agv::model
