// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/link_table_model.h"

#include "model/messages.h"
#include "model/words.h"

#include <QLocale>

#include <algorithm>

namespace agv::model {
LinkTableModel::LinkTableModel(QObject* parent) : QAbstractTableModel(parent) {}

std::vector<LinkTableModel::Row> LinkTableModel::rowsOf(const PlantSnapshot& snapshot)
{
    std::vector<Row> rows;
    rows.reserve(snapshot.agvs.size() * 2 + 1);
    for (const AgvSnapshot& agv : snapshot.agvs) {
        rows.push_back({agv.id.number, Kind::Reader, agv.readerLink, {}});
        rows.push_back({agv.id.number, Kind::Robot, agv.robotLink, {}});
    }
    if (snapshot.uwb) {
        rows.push_back({0, Kind::Uwb, snapshot.uwb->link, snapshot.uwb});
        rows.back().uwb->link = {};
        rows.back().uwb->tags.clear();
        rows.back().uwb->anchors.clear();
        rows.back().uwb->anchorPairs.clear();
        rows.back().uwb->calibration = {};
    }
    return rows;
}

void LinkTableModel::setSnapshot(const PlantSnapshot& snapshot)
{
    std::vector<Row> rows = rowsOf(snapshot);
    if (rows.size() != m_rows.size()) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
        return;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i] == m_rows[i])
            continue;
        m_rows[i] = std::move(rows[i]);
        const int row = static_cast<int>(i);
        emit dataChanged(index(row, 0), index(row, ColumnCount - 1));
    }
}

int LinkTableModel::countIn(LinkState state) const
{
    return static_cast<int>(std::count_if(m_rows.begin(), m_rows.end(),
                                          [state](const Row& row) { return row.link.state == state; }));
}

int LinkTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int LinkTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString LinkTableModel::text(const Row& row, int column)
{
    const LinkSnapshot& link = row.link;
    switch (column) {
    case Connection:
        if (row.kind == Kind::Uwb)
            return row.uwb->dialect == UwbDialect::Unknown
                       ? tr("UWB")
                       : tr("UWB (%1)").arg(QString::fromLatin1(toText(row.uwb->dialect)));
        return row.kind == Kind::Reader ? tr("AGV %1 RFID").arg(row.robot)
                                        : tr("AGV %1 robot").arg(row.robot);
    case State:
        return Words::linkState(link.state);
    case Data:
        return link.state == LinkState::Up ? Words::rate(link.messagesPerSecond) : Words::none();
    case Dropped:
        return QLocale().toString(static_cast<qulonglong>(link.dropped));
    default:
        return {};
    }
}

QString LinkTableModel::detail(const Row& row, int column)
{
    if (column == Connection)
        return QString::fromStdString(row.link.address);
    if (column == Data && row.link.dataAge_s)
        return tr("%1 ago", "age of the last message").arg(Words::age(*row.link.dataAge_s));
    if (column == State && row.link.state == LinkState::Waiting && row.link.retryIn_s)
        return tr("in %1", "time until the next try").arg(Words::age(*row.link.retryIn_s));
    return {};
}

QString LinkTableModel::toolTip(const Row& row)
{
    const LinkSnapshot& link = row.link;
    QStringList lines{Messages::source(link.name) + QStringLiteral(": ") + Words::linkState(link.state)};
    if (!link.address.empty())
        lines << tr("Address: %1").arg(QString::fromStdString(link.address));
    if (!link.reason.empty())
        lines << Messages::sentence(link.reason);
    lines << tr("Received: %1 messages").arg(QLocale().toString(static_cast<qulonglong>(link.received)));
    lines << (link.dropDetail.empty() ? tr("Dropped: none")
                                      : tr("Dropped: %1").arg(Messages::drops(link.dropDetail)));
    if (row.uwb)
        lines << uwbLines(*row.uwb);
    return lines.join(QLatin1Char('\n'));
}

QStringList LinkTableModel::uwbLines(const UwbSnapshot& uwb)
{
    const QString dialect = QString::fromLatin1(toText(uwb.dialect));
    QStringList lines;
    if (uwb.dialectIsChosen)
        lines << tr("Dialect: %1, as the plant file says").arg(dialect);
    else if (uwb.dialect != UwbDialect::Unknown)
        lines << tr("Dialect: %1, found from the reports").arg(dialect);
    if (uwb.unit) {
        const UwbConfiguration& unit = uwb.unit->configuration;
        lines << tr("Unit: %1, number %2, channel %3, %4")
                     .arg(QString::fromStdString(uwb.unit->version))
                     .arg(unit.address)
                     .arg(unit.channel)
                     .arg(unit.fastMode ? tr("6.81 Mb/s") : tr("110 kb/s"));
    } else if (!uwb.unitNote.empty()) {
        lines << Messages::sentence(uwb.unitNote);
    }
    lines << tr("Exchanges missed: %1").arg(QLocale().toString(static_cast<qulonglong>(uwb.missed)));
    return lines;
}

QVariant LinkTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return toolTip(row);
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::Alignment(index.column() >= Data ? Qt::AlignRight | Qt::AlignVCenter
                                                                        : Qt::AlignLeft | Qt::AlignVCenter));
    case RobotRole:
        return row.robot;
    case KindRole:
        return static_cast<int>(row.kind);
    case LinkStateRole:
        return static_cast<int>(row.link.state);
    case DetailRole:
        return detail(row, index.column());
    default:
        return {};
    }
}

QVariant LinkTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::Alignment(section >= Data ? Qt::AlignRight | Qt::AlignVCenter
                                                                 : Qt::AlignLeft | Qt::AlignVCenter));
    if (role == Qt::ToolTipRole && section == Data)
        return tr("Messages per second, and the age of the last one");
    if (role == Qt::ToolTipRole && section == Dropped)
        return tr("Messages that could not be used; hover a row for the reasons");
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Connection:
        return tr("Connection");
    case State:
        return tr("State");
    case Data:
        return tr("Rate, age");
    case Dropped:
        return tr("Dropped");
    default:
        return {};
    }
}

} // namespace agv::model
