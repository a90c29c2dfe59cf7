// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/alarm.h"

#include <vector>

namespace agv::model {

/// The alarms of the plant, in the order of the session: by weight, then the newest first; the shelved ones
/// last. GUI thread.
class AlarmTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Priority, Time, Source, Text, State, ColumnCount };
    enum Role {
        PriorityRole = Qt::UserRole, ///< int(AlarmPriority)
        StateRole,                   ///< int(AlarmState)
    };

    explicit AlarmTableModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// Rows that stay keep their indexes, so that a selection survives.
    void setAlarms(const std::vector<AlarmSnapshot>& alarms);
    const std::vector<AlarmSnapshot>& alarms() const { return m_alarms; }
    /// Those an operator has to look at: neither acknowledged, shelved nor held back.
    int newCount() const;
    /// Those that hold, without the shelved ones.
    int activeCount() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    static QString text(const AlarmSnapshot& alarm, int column);

    std::vector<AlarmSnapshot> m_alarms;
};

} // namespace agv::model
