// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QStringList>

#include "core/snapshot.h"

#include <optional>
#include <vector>

namespace agv::model {

/// One row per connection of the plant: for every AGV its RFID reader, then its robot; last the UWB unit. GUI
/// thread. Rows stay in place from snapshot to snapshot, and only cells that changed are announced, so a
/// selection survives.
class LinkTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum class Kind { Reader, Robot, Uwb };
    enum Column { Connection, State, Data, Dropped, ColumnCount };
    enum Role {
        RobotRole = Qt::UserRole, ///< int, number of the AGV; 0 for the UWB unit
        KindRole,                 ///< int(Kind)
        LinkStateRole,            ///< int(LinkState)
        DetailRole,               ///< second line of a cell, empty when there is none
    };

    explicit LinkTableModel(QObject* parent = nullptr);

    void setSnapshot(const PlantSnapshot& snapshot);
    const LinkSnapshot& link(int row) const { return m_rows[static_cast<std::size_t>(row)].link; }
    int countIn(LinkState state) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        int robot = 0;
        Kind kind = Kind::Reader;
        LinkSnapshot link;
        std::optional<UwbSnapshot> uwb; ///< of the UWB unit; without its link and tags
        friend bool operator==(const Row&, const Row&) = default;
    };
    static std::vector<Row> rowsOf(const PlantSnapshot& snapshot);
    static QString text(const Row& row, int column);
    static QString detail(const Row& row, int column);
    static QString toolTip(const Row& row);
    static QStringList uwbLines(const UwbSnapshot& uwb);

    std::vector<Row> m_rows;
};

} // namespace agv::model
