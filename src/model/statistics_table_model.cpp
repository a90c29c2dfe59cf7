// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/statistics_table_model.h"

#include "model/words.h"

#include <QLocale>

#include <cmath>

namespace agv::model {
namespace {

/// Four figures, but no more than two decimals.
QString figure(double value)
{
    const double magnitude = std::abs(value);
    return QLocale().toString(value, 'f', magnitude >= 100.0 ? 0 : magnitude >= 10.0 ? 1 : 2);
}

} // namespace

void StatisticsTableModel::setRows(const std::vector<Row>& rows, const QString& unit)
{
    if (unit != m_unit) {
        m_unit = unit;
        emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    }
    if (rows.size() != m_rows.size()) {
        beginResetModel();
        m_rows = rows;
        endResetModel();
        return;
    }
    m_rows = rows;
    if (!m_rows.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int StatisticsTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int StatisticsTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant StatisticsTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    if (index.column() == Name)
        return row.name;
    if (index.column() == AtCursor)
        return row.atCursor ? figure(*row.atCursor) : Words::none();
    if (!row.statistics)
        return Words::none();
    const SeriesStatistics& s = *row.statistics;
    switch (index.column()) {
    case Count:
        return QLocale().toString(static_cast<qulonglong>(s.count));
    case Mean:
        return figure(s.mean);
    case Sd:
        return figure(s.sd);
    case Rms:
        return figure(s.rms);
    case Median:
        return figure(s.median);
    case P50:
        return figure(s.p50);
    case P75:
        return figure(s.p75);
    case P95:
        return figure(s.p95);
    case Largest:
        return figure(s.largest);
    case Availability:
        return Words::percent(s.availability);
    default:
        return {};
    }
}

QVariant StatisticsTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const auto withUnit = [this](const QString& text) { return QStringLiteral("%1, %2").arg(text, m_unit); };
    if (role == Qt::ToolTipRole) {
        switch (section) {
        case P50:
        case P75:
        case P95:
            return tr("Of the magnitudes: of a position error the circular errors CE50, CE75, CE95");
        case Mean:
            return tr("Of an error: the bias");
        case Availability:
            return tr("Share of the time with a value not older than 1 s");
        default:
            return {};
        }
    }
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name:
        return tr("Curve");
    case AtCursor:
        return withUnit(tr("At the cursor"));
    case Count:
        return tr("Values");
    case Mean:
        return withUnit(tr("Mean"));
    case Sd:
        return withUnit(tr("Std. dev."));
    case Rms:
        return withUnit(tr("RMS"));
    case Median:
        return withUnit(tr("Median"));
    case P50:
        return withUnit(tr("50 %"));
    case P75:
        return withUnit(tr("75 %"));
    case P95:
        return withUnit(tr("95 %"));
    case Largest:
        return withUnit(tr("Largest"));
    case Availability:
        return tr("Available");
    default:
        return {};
    }
}

} // namespace agv::model
