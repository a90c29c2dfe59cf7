// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/snapshot.h"

#include <deque>

namespace agv::model {

/// The event log, oldest first, bounded: the oldest entries leave when `capacity` is reached. An event that
/// repeats the last one of its source is counted there instead of making a row of its own. GUI thread.
class EventTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Time, Level, Source, Text, ColumnCount };
    enum Role { LevelRole = Qt::UserRole }; ///< int(EventLevel)

    explicit EventTableModel(int capacity = 2000, QObject* parent = nullptr);

    void append(const EventEntry& entry);
    void clear();
    int capacity() const { return m_capacity; }

    /// One row as "2026-03-17T15:30:05.123Z <tab> Warning <tab> AGV 1 <tab> text".
    QString rowText(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        EventEntry entry;
        int count = 1;
        std::int64_t last_ms = 0; ///< wall clock of the last repetition
    };
    static QString text(const Row& row, int column);
    bool countRepetition(const EventEntry& entry);

    std::deque<Row> m_rows;
    int m_capacity;
};

} // namespace agv::model
