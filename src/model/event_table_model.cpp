// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/event_table_model.h"

#include "model/messages.h"
#include "model/words.h"

#include <QDateTime>
#include <QLocale>

#include <algorithm>

namespace agv::model {
namespace {

QString clock(std::int64_t utc_ms, const QString& format)
{
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(utc_ms), format);
}

} // namespace

EventTableModel::EventTableModel(int capacity, QObject* parent)
    : QAbstractTableModel(parent),
      m_capacity(std::max(1, capacity))
{}

void EventTableModel::append(const EventEntry& entry)
{
    if (countRepetition(entry))
        return;
    if (static_cast<int>(m_rows.size()) >= m_capacity) {
        beginRemoveRows({}, 0, 0);
        m_rows.pop_front();
        endRemoveRows();
    }
    const int row = static_cast<int>(m_rows.size());
    beginInsertRows({}, row, row);
    m_rows.push_back({entry, 1, entry.utc_ms});
    endInsertRows();
}

bool EventTableModel::countRepetition(const EventEntry& entry)
{
    const auto last = std::find_if(m_rows.rbegin(), m_rows.rend(), [&](const Row& row) {
        // A detail between two events is not seen, so it does not part them.
        return row.entry.source == entry.source &&
               (row.entry.level == EventLevel::Detail) == (entry.level == EventLevel::Detail);
    });
    if (last == m_rows.rend() || last->entry.level != entry.level || last->entry.text != entry.text)
        return false;
    ++last->count;
    last->last_ms = entry.utc_ms;
    const int row = static_cast<int>(std::distance(last, m_rows.rend())) - 1;
    emit dataChanged(index(row, 0), index(row, ColumnCount - 1));
    return true;
}

void EventTableModel::clear()
{
    beginResetModel();
    m_rows.clear();
    endResetModel();
}

int EventTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int EventTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString EventTableModel::text(const Row& row, int column)
{
    const EventEntry& entry = row.entry;
    switch (column) {
    case Time:
        return clock(entry.utc_ms, QStringLiteral("HH:mm:ss"));
    case Level:
        return Words::eventLevel(entry.level);
    case Source:
        return Messages::source(entry.source);
    case Text: {
        const QString sentence = Messages::sentence(entry.text);
        return row.count == 1 ? sentence
                              : tr("%1 (%2 times, last at %3)")
                                    .arg(sentence, QLocale().toString(row.count),
                                         clock(row.last_ms, QStringLiteral("HH:mm:ss")));
    }
    default:
        return {};
    }
}

QString EventTableModel::rowText(int row) const
{
    const Row& shown = m_rows[static_cast<std::size_t>(row)];
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(shown.entry.utc_ms).toUTC();
    return QStringList{time.toString(Qt::ISODateWithMs), text(shown, Level), text(shown, Source),
                       text(shown, Text)}
        .join(QLatin1Char('\t'));
}

QVariant EventTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::ToolTipRole:
        return index.column() == Time ? clock(row.entry.utc_ms, QStringLiteral("d MMM yyyy HH:mm:ss.zzz"))
                                      : text(row, Text);
    case LevelRole:
        return static_cast<int>(row.entry.level);
    default:
        return {};
    }
}

QVariant EventTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::Alignment(Qt::AlignLeft | Qt::AlignVCenter));
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Time:
        return tr("Time");
    case Level:
        return tr("Level");
    case Source:
        return tr("Source");
    case Text:
        return tr("Text");
    default:
        return {};
    }
}

} // namespace agv::model
