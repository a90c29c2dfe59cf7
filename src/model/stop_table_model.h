// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/snapshot.h"

#include <vector>

namespace agv::model {

/// True when the reads of a stop contradict the result.
bool isSuspicious(const StopReport& stop);

/// The operator's table of an initialisation turn: one row per stop, the tags' ids, then their RSSI, as many
/// columns as the fullest stop needs (seed, table 10). GUI thread.
class StopTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Stop, Reads, FirstTag };
    enum Role {
        DoneRole = Qt::UserRole, ///< bool, the stop has been read to its end
        WarningRole,             ///< bool, the stop's number: its reads contradict the result
    };

    explicit StopTableModel(QObject* parent = nullptr);

    void setTurn(const TurnSnapshot& turn);

    /// Tag columns shown; the RSSI columns are as many again.
    int tagColumns() const { return m_tagColumns; }

    /// The whole table, columns separated by tabs, rows by line feeds, a heading line first; ids in full.
    /// recording/table_turns.h reads it.
    QString toText() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    bool isRssiColumn(int column) const { return column >= FirstTag + m_tagColumns; }
    static QString title(int column, int tagColumns);
    QString text(const StopRow& row, int column) const;
    QString toolTip(const StopRow& row, int column) const;
    const StopReport* report(int row) const;

    std::vector<StopRow> m_rows;
    std::shared_ptr<const TurnEstimate> m_estimate;
    int m_tagColumns = 0;
};

} // namespace agv::model
