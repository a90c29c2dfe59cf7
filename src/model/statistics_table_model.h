// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "model/series_statistics.h"

#include <optional>
#include <vector>

namespace agv::model {

/// One row a curve: its value at the cursor, and the statistics of what is visible. GUI thread.
class StatisticsTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column {
        Name,
        AtCursor,
        Count,
        Mean,
        Sd,
        Rms,
        Median,
        P50,
        P75,
        P95,
        Largest,
        Availability,
        ColumnCount
    };
    struct Row {
        QString name;
        std::optional<double> atCursor;
        std::optional<SeriesStatistics> statistics;
    };

    explicit StatisticsTableModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// `unit` stands in the heads of the columns that have it.
    void setRows(const std::vector<Row>& rows, const QString& unit);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<Row> m_rows;
    QString m_unit;
};

} // namespace agv::model
