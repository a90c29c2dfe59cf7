// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/floor_tag_table_model.h"

#include "model/words.h"

#include <algorithm>

namespace agv::model {
namespace {

constexpr Duration refreshInterval = std::chrono::milliseconds(500);

bool isRead(const std::optional<FloorTagStates::LastRead>& last) { return last.has_value(); }

} // namespace

void FloorTagTableModel::setTags(const std::vector<FloorTag>& tags)
{
    beginResetModel();
    m_rows.clear();
    for (const FloorTag& tag : tags)
        m_rows.push_back({tag, FloorTagState::NotSeen, std::nullopt});
    m_listed = m_rows.size();
    m_states.clear();
    endResetModel();
}

void FloorTagTableModel::setSnapshot(const PlantSnapshot& snapshot)
{
    m_states.add(snapshot);
    if (snapshot.time - m_shown < refreshInterval && m_shown != Time{})
        return;
    m_shown = snapshot.time;
    updateUnknown();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        Row& row = m_rows[i];
        const FloorTagState state = i < m_listed ? m_states.stateOf(row.tag.uid) : FloorTagState::Unknown;
        std::optional<FloorTagStates::LastRead> last = m_states.lastRead(row.tag.uid);
        // The age of what was read goes on by itself.
        if (state == row.state && !isRead(last))
            continue;
        row.state = state;
        row.last = last;
        emit dataChanged(index(static_cast<int>(i), 0), index(static_cast<int>(i), ColumnCount - 1));
    }
}

void FloorTagTableModel::updateUnknown()
{
    const std::vector<FloorTagStates::Unknown>& unknown = m_states.unknown();
    const bool isSame = std::ranges::equal(
        m_rows.begin() + static_cast<std::ptrdiff_t>(m_listed), m_rows.end(), unknown.begin(), unknown.end(),
        {}, [](const Row& row) { return row.tag.uid; }, &FloorTagStates::Unknown::uid);
    if (isSame)
        return;
    const int first = static_cast<int>(m_listed);
    if (m_rows.size() > m_listed) {
        beginRemoveRows({}, first, rowCount() - 1);
        m_rows.resize(m_listed);
        endRemoveRows();
    }
    if (unknown.empty())
        return;
    beginInsertRows({}, first, first + static_cast<int>(unknown.size()) - 1);
    for (const FloorTagStates::Unknown& each : unknown) {
        Row row;
        row.tag.uid = each.uid;
        row.tag.position = each.antenna;
        row.state = FloorTagState::Unknown;
        m_rows.push_back(row);
    }
    endInsertRows();
}

Point2 FloorTagTableModel::placeOf(int row) const
{
    return m_rows.at(static_cast<std::size_t>(row)).tag.position;
}

int FloorTagTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int FloorTagTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString FloorTagTableModel::stateText(FloorTagState state)
{
    switch (state) {
    case FloorTagState::NotSeen:
        return tr("Not read");
    case FloorTagState::SeenNow:
        return tr("Read now");
    case FloorTagState::SeenBefore:
        return tr("Read before");
    case FloorTagState::Missing:
        return tr("Missing");
    case FloorTagState::Unknown:
        return tr("Unknown");
    }
    return {};
}

QString FloorTagTableModel::text(const Row& row, int column) const
{
    switch (column) {
    case Number:
        return row.state == FloorTagState::Unknown ? Words::none() : QString::number(row.tag.number);
    case Short:
        return QString::fromStdString(shortText(row.tag.uid));
    case Uid:
        return QString::fromStdString(fullText(row.tag.uid));
    case X:
        return Words::millimetres(row.tag.position.x);
    case Y:
        return Words::millimetres(row.tag.position.y);
    case State:
        return stateText(row.state);
    case Robot:
        return row.last ? tr("AGV %1").arg(row.last->robot) : Words::none();
    case Rssi:
        return row.last ? QString::number(row.last->rssi) : Words::none();
    case Age:
        return row.last ? Words::age(secondsFrom(m_states.time() - row.last->time)) : Words::none();
    default:
        return {};
    }
}

QVariant FloorTagTableModel::sortKey(const Row& row, int column) const
{
    constexpr double never = 1e12;
    switch (column) {
    case Number:
        return row.tag.number;
    case Short:
    case Uid:
        return static_cast<qulonglong>(row.tag.uid.value);
    case X:
        return row.tag.position.x;
    case Y:
        return row.tag.position.y;
    case State:
        return static_cast<int>(row.state);
    case Robot:
        return row.last ? row.last->robot : 0;
    case Rssi:
        return row.last ? row.last->rssi : -1;
    case Age:
        return row.last ? secondsFrom(m_states.time() - row.last->time) : never;
    default:
        return {};
    }
}

QVariant FloorTagTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    const bool isWarning = row.state == FloorTagState::Missing || row.state == FloorTagState::Unknown;
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::TextAlignmentRole:
        return int(
            (index.column() == X || index.column() == Y || index.column() == Number || index.column() == Rssi
                 ? Qt::AlignRight
                 : Qt::AlignLeft) |
            Qt::AlignVCenter);
    case SortRole:
        return sortKey(row, index.column());
    case StateRole:
        return static_cast<int>(row.state);
    case WarningRole:
        return isWarning && index.column() == State;
    default:
        return {};
    }
}

QVariant FloorTagTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Number:
        return tr("Number");
    case Short:
        return tr("Short");
    case Uid:
        return tr("UID");
    case X:
        return tr("x");
    case Y:
        return tr("y");
    case State:
        return tr("State");
    case Robot:
        return tr("Read by");
    case Rssi:
        return tr("RSSI, steps");
    case Age:
        return tr("Last read");
    default:
        return {};
    }
}

} // namespace agv::model
