// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/uwb_tag_table_model.h"

#include "core/units.h"
#include "model/anchor_table_model.h"
#include "model/cell_input.h"
#include "model/messages.h"
#include "model/uncertainty.h"
#include "model/words.h"

#include <algorithm>
#include <cmath>

namespace agv::model {
namespace {

bool isText(int column)
{
    return column == UwbTagTableModel::Label || column == UwbTagTableModel::Agv ||
           column == UwbTagTableModel::State;
}

} // namespace

QString uwbTagName(const UwbTag& tag)
{
    return tag.label.empty() ? UwbTagTableModel::tr("UWB tag %1").arg(tag.id)
                             : QString::fromStdString(tag.label);
}

UwbTagTableModel::UwbTagTableModel(QObject* parent) : QAbstractTableModel(parent) {}

void UwbTagTableModel::setSettings(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings)
{
    m_settings = settings;
    const bool newColumns = anchors.size() != m_anchors.size();
    if (newColumns)
        beginResetModel();
    const bool renamed = anchors != m_anchors;
    m_anchors = anchors;
    if (newColumns) {
        m_rows = rowsNow();
        endResetModel();
        return;
    }
    update();
    if (!renamed || m_anchors.empty())
        return;
    emit headerDataChanged(Qt::Horizontal, FirstRange, columnCount() - 1);
    if (!m_rows.empty())
        emit dataChanged(index(0, FirstRange), index(rowCount() - 1, columnCount() - 1));
}

void UwbTagTableModel::setSnapshot(const UwbSnapshot* uwb)
{
    m_heard = uwb ? uwb->tags : std::vector<UwbTagSnapshot>();
    update();
}

std::vector<UwbTagTableModel::Row> UwbTagTableModel::rowsNow() const
{
    std::vector<Row> rows;
    for (const UwbTag& tag : m_settings.tags)
        rows.push_back({tag, true, {}});
    for (const UwbTagSnapshot& heard : m_heard) {
        auto row = std::ranges::find(rows, heard.id, [](const Row& r) { return r.tag.id; });
        if (row == rows.end()) {
            UwbTag tag;
            tag.id = heard.id;
            tag.z_m = m_settings.tagHeight_m;
            row = rows.insert(rows.end(), Row{tag, false, {}});
        }
        row->heard = heard;
    }
    std::ranges::sort(rows.begin() + static_cast<std::ptrdiff_t>(m_settings.tags.size()), rows.end(), {},
                      [](const Row& r) { return r.tag.id; });
    return rows;
}

void UwbTagTableModel::update()
{
    std::vector<Row> rows = rowsNow();
    if (!takeOverIds(rows)) {
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
        emit dataChanged(index(row, 0), index(row, columnCount() - 1));
    }
}

/// A tag that comes or goes must not take selection and a half-typed text from the others, so rows are
/// inserted and removed one by one. False when the order is another one.
bool UwbTagTableModel::takeOverIds(const std::vector<Row>& rows)
{
    const auto idOf = [](const Row& row) { return row.tag.id; };
    for (int row = rowCount() - 1; row >= 0; --row) {
        const auto place = m_rows.begin() + row;
        if (std::ranges::find(rows, place->tag.id, idOf) != rows.end())
            continue;
        beginRemoveRows({}, row, row);
        m_rows.erase(place);
        endRemoveRows();
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i < m_rows.size() && m_rows[i].tag.id == rows[i].tag.id)
            continue;
        if (std::ranges::find(m_rows, rows[i].tag.id, idOf) != m_rows.end())
            return false;
        beginInsertRows({}, static_cast<int>(i), static_cast<int>(i));
        m_rows.insert(m_rows.begin() + static_cast<std::ptrdiff_t>(i), rows[i]);
        endInsertRows();
    }
    return true;
}

int UwbTagTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int UwbTagTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : FirstRange + static_cast<int>(m_anchors.size());
}

QString UwbTagTableModel::agvName(int number) const
{
    const auto agv =
        std::ranges::find(m_agvs, number, [](const AgvConfig& config) { return config.id.number; });
    return agv == m_agvs.end() || agv->name.empty() ? tr("AGV %1").arg(number)
                                                    : QString::fromStdString(agv->name);
}

const UwbRangeSnapshot* UwbTagTableModel::range(const Row& row, int column) const
{
    if (!row.heard || column < FirstRange)
        return nullptr;
    const int anchor = m_anchors[static_cast<std::size_t>(column - FirstRange)].id;
    const auto found = std::ranges::find(row.heard->ranges, anchor, &UwbRangeSnapshot::anchor);
    return found == row.heard->ranges.end() ? nullptr : &*found;
}

QString UwbTagTableModel::rangeText(const Row& row, int column) const
{
    const UwbRangeSnapshot* measured = range(row, column);
    if (!measured)
        return CellInput::none();
    const QString mm = CellInput::shown(mmFromMetres(measured->range_m), 0);
    // A cross as on a crossed-out number: the mark needs no colour.
    return measured->rejected ? QStringLiteral("%1 %2").arg(QChar(0x2715)).arg(mm) : mm;
}

QString UwbTagTableModel::stateText(const Row& row) const
{
    if (!row.heard)
        return tr("Not heard");
    return row.heard->position ? tr("Fix") : Messages::sentence(row.heard->reason);
}

QString UwbTagTableModel::text(const Row& row, int column) const
{
    if (column >= FirstRange)
        return rangeText(row, column);
    const UwbTagSnapshot* heard = row.heard ? &*row.heard : nullptr;
    const bool fix = heard && heard->position;
    switch (column) {
    case Id:
        return QString::number(row.tag.id);
    case Label:
        return row.listed ? QString::fromStdString(row.tag.label) : tr("not listed");
    case Agv:
        return row.tag.agv ? agvName(row.tag.agv->number) : CellInput::none();
    case Height:
        return CellInput::shown(mmFromMetres(row.tag.z_m), 0);
    case X:
        return fix ? CellInput::shown(mmFromMetres(heard->position->x), 0) : CellInput::none();
    case Y:
        return fix ? CellInput::shown(mmFromMetres(heard->position->y), 0) : CellInput::none();
    case Uncertainty: // rounded up, never down
        return fix ? CellInput::shown(std::ceil(mmFromMetres(ellipse95(heard->covariance).major_m)), 0)
                   : CellInput::none();
    case Age:
        return heard ? Words::age(heard->age_s) : CellInput::none();
    case Rate:
        return heard ? CellInput::shown(heard->reportsPerSecond, 1) : CellInput::none();
    case Repeatability:
        return heard && heard->r95_m ? CellInput::shown(mmFromMetres(*heard->r95_m), 0) : CellInput::none();
    case State:
        return stateText(row);
    default:
        return {};
    }
}

QString UwbTagTableModel::rangeToolTip(const Row& row, int column) const
{
    const QString anchor = anchorName(m_anchors[static_cast<std::size_t>(column - FirstRange)]);
    const UwbRangeSnapshot* measured = range(row, column);
    if (!measured)
        return tr("No range to %1 in the last report").arg(anchor);
    QStringList lines;
    if (measured->rejected)
        lines << tr("Not used: the range to %1 does not fit the others, its view is probably blocked")
                     .arg(anchor);
    if (measured->residual_m)
        lines << tr("Measured minus expected: %1").arg(Words::millimetres(*measured->residual_m));
    return lines.isEmpty() ? tr("Range to %1, corrected").arg(anchor) : lines.join(QLatin1Char('\n'));
}

QString UwbTagTableModel::toolTip(const Row& row, int column) const
{
    if (column >= FirstRange)
        return rangeToolTip(row, column);
    if (column == State && !row.heard)
        return tr("No report of this tag yet: switch it on and open the UWB unit");
    if (column == State)
        return stateText(row);
    if (column <= Height && !row.listed)
        return tr(
            "This tag is heard but is not in the list: an entry of a label, an AGV or a height lists it");
    if (column == Repeatability && row.heard && !row.heard->r95_m)
        return tr("Too few positions yet");
    if (column == Rate && row.heard)
        return tr("%1 reports, %2 exchanges missed").arg(row.heard->reports).arg(row.heard->missed);
    return headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
}

QVariant UwbTagTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    switch (role) {
    case Qt::DisplayRole:
        return text(row, column);
    case Qt::EditRole:
        if (column == Height)
            return CellInput::editable(mmFromMetres(row.tag.z_m));
        return column == Label ? QString::fromStdString(row.tag.label) : text(row, column);
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return toolTip(row, column);
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::Alignment(isText(column) ? Qt::AlignLeft | Qt::AlignVCenter
                                                                : Qt::AlignRight | Qt::AlignVCenter));
    case WarningRole:
        return column == State && row.heard && !row.heard->position;
    case TagRole:
        return row.tag.id;
    case ListedRole:
        return row.listed;
    case ChoicesRole: {
        if (column != Agv)
            return {};
        QStringList names{CellInput::none()};
        for (const AgvConfig& agv : m_agvs)
            names << agvName(agv.id.number);
        return names;
    }
    default:
        return {};
    }
}

QVariant UwbTagTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::Alignment(isText(section) ? Qt::AlignLeft | Qt::AlignVCenter
                                                                 : Qt::AlignRight | Qt::AlignVCenter));
    const auto choose = [role](const QString& title, const QString& tip) {
        return role == Qt::DisplayRole   ? QVariant(title)
               : role == Qt::ToolTipRole ? QVariant(tip)
                                         : QVariant();
    };
    switch (section) {
    case Id:
        return choose(tr("No.", "number of a UWB tag"), tr("Number of the tag, as in the reports: 0 to 255"));
    case Label:
        return choose(tr("Tag"), tr("Name on the map and in messages"));
    case Agv:
        return choose(tr("AGV"), tr("The AGV that carries the tag"));
    case Height:
        return choose(tr("z (mm)"), tr("Height of the tag's antenna above the floor"));
    case X:
        return choose(tr("x (mm)"), tr("Position of the tag's antenna, to the east of the plant's origin"));
    case Y:
        return choose(tr("y (mm)"), tr("Position of the tag's antenna, to the north of the plant's origin"));
    case Uncertainty:
        return choose(tr("95 % (mm)"),
                      tr("The position lies within this of x and y with 95 % certainty, for anchors "
                         "that stand where the list says"));
    case Age:
        return choose(tr("Age"), tr("Time since the ranges were measured"));
    case Rate:
        return choose(tr("Rate (1/s)"), tr("Reports per second"));
    case Repeatability:
        return choose(
            tr("R95 (mm)"),
            tr("Repeatability: 95 % of the last positions lie within this of their own mean. It says nothing "
               "of how far that mean is from the truth"));
    case State:
        return choose(tr("State"), tr("Fix: there is a position; else the reason why there is none"));
    default:
        break;
    }
    const QString anchor = anchorName(m_anchors[static_cast<std::size_t>(section - FirstRange)]);
    return choose(tr("%1 (mm)", "range to this anchor").arg(anchor),
                  tr("Last range to %1, corrected. A cross marks a range that is not used").arg(anchor));
}

} // namespace agv::model
