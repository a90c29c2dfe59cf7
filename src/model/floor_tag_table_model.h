// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/plant_layout.h"
#include "model/floor_tag_states.h"

#include <optional>
#include <vector>

namespace agv::model {

/// The floor tags of the plant, then those that were read and are in no list. GUI thread.
class FloorTagTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Number, Short, Uid, X, Y, State, Robot, Rssi, Age, ColumnCount };
    enum Role {
        SortRole = Qt::UserRole, ///< a number, or text, to sort by
        StateRole,               ///< int(FloorTagState)
        WarningRole,             ///< bool: missing or unknown
    };

    explicit FloorTagTableModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void setTags(const std::vector<FloorTag>& tags);
    /// At most twice a second of the snapshots' time; only rows that differ are told.
    void setSnapshot(const PlantSnapshot& snapshot);
    /// m; of an unknown tag where the antenna was.
    Point2 placeOf(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    static QString stateText(FloorTagState state);

private:
    struct Row {
        FloorTag tag;
        FloorTagState state = FloorTagState::NotSeen;
        std::optional<FloorTagStates::LastRead> last;
    };
    void updateUnknown();
    QString text(const Row& row, int column) const;
    QVariant sortKey(const Row& row, int column) const;

    FloorTagStates m_states;
    std::vector<Row> m_rows;
    std::size_t m_listed = 0; ///< rows of the plant's list; the others are unknown
    Time m_shown;
};

} // namespace agv::model
