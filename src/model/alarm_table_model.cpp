// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/alarm_table_model.h"

#include "model/alarm_words.h"

#include <QDateTime>

#include <algorithm>

namespace agv::model {

void AlarmTableModel::setAlarms(const std::vector<AlarmSnapshot>& alarms)
{
    if (alarms == m_alarms)
        return;
    const bool sameRows = std::ranges::equal(alarms, m_alarms, {}, &AlarmSnapshot::key, &AlarmSnapshot::key);
    if (!sameRows) {
        // Few rows that seldom come and go: the whole order anew, the chosen ones followed by their key.
        emit layoutAboutToBeChanged();
        const QModelIndexList before = persistentIndexList();
        QModelIndexList after;
        for (const QModelIndex& index : before) {
            const AlarmKey key = m_alarms[static_cast<std::size_t>(index.row())].key;
            const auto found = std::ranges::find(alarms, key, &AlarmSnapshot::key);
            after << (found == alarms.end()
                          ? QModelIndex()
                          : createIndex(static_cast<int>(found - alarms.begin()), index.column()));
        }
        m_alarms = alarms;
        changePersistentIndexList(before, after);
        emit layoutChanged();
        return;
    }
    m_alarms = alarms;
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int AlarmTableModel::newCount() const
{
    return static_cast<int>(std::ranges::count_if(m_alarms, [](const AlarmSnapshot& alarm) {
        return !alarm.heldBack &&
               (alarm.state == AlarmState::Unacknowledged || alarm.state == AlarmState::Returned);
    }));
}

int AlarmTableModel::activeCount() const
{
    return static_cast<int>(std::ranges::count_if(m_alarms, [](const AlarmSnapshot& alarm) {
        return alarm.holds && alarm.state != AlarmState::Shelved;
    }));
}

int AlarmTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_alarms.size());
}

int AlarmTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString AlarmTableModel::text(const AlarmSnapshot& alarm, int column)
{
    switch (column) {
    case Priority:
        return AlarmWords::priority(alarm.priority);
    case Time:
        return QDateTime::fromMSecsSinceEpoch(alarm.raised_utc_ms).toString(QStringLiteral("HH:mm:ss"));
    case Source:
        return AlarmWords::source(alarm.key);
    case Text: {
        const QString text =
            AlarmWords::what(alarm) + QStringLiteral(". ") + AlarmWords::remedy(alarm.key.kind);
        return alarm.occurrences > 1 ? tr("%1 (%2 times)").arg(text).arg(alarm.occurrences) : text;
    }
    case State:
        return AlarmWords::state(alarm);
    default:
        return {};
    }
}

QVariant AlarmTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const AlarmSnapshot& alarm = m_alarms[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return text(alarm, index.column());
    case Qt::ToolTipRole:
        return text(alarm, Text);
    case PriorityRole:
        return static_cast<int>(alarm.priority);
    case StateRole:
        return static_cast<int>(alarm.state);
    default:
        return {};
    }
}

QVariant AlarmTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Priority:
        return tr("Priority");
    case Time:
        return tr("Time");
    case Source:
        return tr("Source");
    case Text:
        return tr("What is the matter, and what to do");
    case State:
        return tr("State");
    default:
        return {};
    }
}

} // namespace agv::model
