// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/stop_table_model.h"

#include "model/words.h"

#include <QLocale>

#include <algorithm>

namespace agv::model {
namespace {

int widestRow(const std::vector<StopRow>& rows)
{
    std::size_t widest = 0;
    for (const StopRow& row : rows)
        widest = std::max(widest, row.tags.size());
    return static_cast<int>(widest);
}

QString names(const std::vector<TagUid>& tags)
{
    QStringList texts;
    for (TagUid tag : tags)
        texts << QString::fromStdString(shortText(tag));
    return texts.join(QStringLiteral(", "));
}

} // namespace

bool isSuspicious(const StopReport& stop)
{
    return stop.missed.size() > 1 || !stop.unknown.empty() || !stop.misplaced.empty();
}

StopTableModel::StopTableModel(QObject* parent) : QAbstractTableModel(parent) {}

void StopTableModel::setTurn(const TurnSnapshot& turn)
{
    const std::shared_ptr<const TurnEstimate>& estimate = turn.result ? turn.result : turn.preview;
    const int tagColumns = widestRow(turn.table);
    if (turn.table.size() != m_rows.size() || tagColumns != m_tagColumns) {
        beginResetModel();
        m_rows = turn.table;
        m_estimate = estimate;
        m_tagColumns = tagColumns;
        endResetModel();
        return;
    }
    const bool newEstimate = estimate != m_estimate;
    m_estimate = estimate;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (!newEstimate && m_rows[i] == turn.table[i])
            continue;
        m_rows[i] = turn.table[i];
        const int row = static_cast<int>(i);
        emit dataChanged(index(row, 0), index(row, columnCount() - 1));
    }
}

int StopTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int StopTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : FirstTag + 2 * m_tagColumns;
}

const StopReport* StopTableModel::report(int row) const
{
    const auto i = static_cast<std::size_t>(row);
    return m_estimate && i < m_estimate->stops.size() ? &m_estimate->stops[i] : nullptr;
}

QString StopTableModel::text(const StopRow& row, int column) const
{
    if (column == Stop)
        return QLocale().toString(row.stop);
    if (column == Reads)
        return row.done || row.reads > 0 ? QLocale().toString(row.reads) : Words::none();
    const bool rssi = isRssiColumn(column);
    const auto tag = static_cast<std::size_t>(column - FirstTag - (rssi ? m_tagColumns : 0));
    if (tag >= row.tags.size())
        return {};
    return rssi ? QLocale().toString(row.tags[tag].second)
                : QString::fromStdString(shortText(row.tags[tag].first));
}

QString StopTableModel::toolTip(const StopRow& row, int column) const
{
    const auto tag = static_cast<std::size_t>(column - FirstTag - (isRssiColumn(column) ? m_tagColumns : 0));
    if (column >= FirstTag && tag < row.tags.size()) {
        return tr("Tag %1, RSSI %2")
            .arg(QString::fromStdString(fullText(row.tags[tag].first)))
            .arg(row.tags[tag].second);
    }
    QStringList lines{tr("Stop %1: %2 reads of %3 tags").arg(row.stop).arg(row.reads).arg(row.tags.size())};
    if (const StopReport* stop = report(row.stop - 1)) {
        if (!stop->missed.empty())
            lines << tr("Expected but not seen: %1").arg(names(stop->missed));
        if (!stop->unknown.empty())
            lines << tr("Not in the plant file: %1").arg(names(stop->unknown));
        if (!stop->misplaced.empty())
            lines << tr("Belongs elsewhere: %1").arg(names(stop->misplaced));
    }
    return lines.join(QLatin1Char('\n'));
}

QVariant StopTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const StopRow& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return toolTip(row, index.column());
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::Alignment(Qt::AlignCenter));
    case DoneRole:
        return row.done;
    case WarningRole: {
        const StopReport* stop = report(index.row());
        return index.column() == Stop && stop && isSuspicious(*stop);
    }
    default:
        return {};
    }
}

QVariant StopTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    return title(section, m_tagColumns);
}

QString StopTableModel::title(int column, int tagColumns)
{
    if (column == Stop)
        return tr("Stop");
    if (column == Reads)
        return tr("Reads");
    const int tag = column - FirstTag;
    return tag < tagColumns ? tr("Tag %1").arg(tag + 1) : tr("RSSI %1").arg(tag - tagColumns + 1);
}

QString StopTableModel::toText() const
{
    // A table without a read keeps its columns too: a file must not take its stops for tags.
    const int tagColumns = std::max(1, m_tagColumns);
    QStringList lines;
    QStringList cells;
    for (int column = 0; column < FirstTag + 2 * tagColumns; ++column)
        cells << title(column, tagColumns);
    lines << cells.join(QLatin1Char('\t'));
    for (const StopRow& row : m_rows) {
        // Files and the clipboard take plain numbers and full ids; the screen takes the short ones.
        cells = {QString::number(row.stop), QString::number(row.reads)};
        for (int i = 0; i < 2 * tagColumns; ++i) {
            const auto tag = static_cast<std::size_t>(i % tagColumns);
            if (tag >= row.tags.size())
                cells << QString();
            else if (i < tagColumns)
                cells << QString::fromStdString(fullText(row.tags[tag].first));
            else
                cells << QString::number(row.tags[tag].second);
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

} // namespace agv::model
