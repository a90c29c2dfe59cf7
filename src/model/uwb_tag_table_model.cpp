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

bool isEditable(int column) { return column <= UwbTagTableModel::Height; }

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
        emit dataChanged(index(row, 0), index(row, columnCount() - 1));
    }
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

Result<std::optional<RobotId>> UwbTagTableModel::agvFrom(const QString& input, const QString& name) const
{
    const QString wanted = input.trimmed();
    if (wanted.isEmpty() || wanted == CellInput::none() || wanted == QLatin1String("0"))
        return std::optional<RobotId>();
    for (const AgvConfig& agv : m_agvs) {
        if (wanted == QString::number(agv.id.number) ||
            wanted.compare(agvName(agv.id.number), Qt::CaseInsensitive) == 0)
            return std::optional(agv.id);
    }
    return failure(ErrorCode::BadInput, tr("There is no AGV \"%1\": choose one of the plant for %2, or none.")
                                            .arg(wanted, name)
                                            .toStdString());
}

Result<UwbTag> UwbTagTableModel::changed(int row, int column, const QString& input) const
{
    UwbTag tag = m_rows[static_cast<std::size_t>(row)].tag;
    const QString name = uwbTagName(tag);
    if (column == Label) {
        tag.label = input.trimmed().toStdString();
        return tag;
    }
    if (column == Agv) {
        const auto agv = agvFrom(input, name);
        if (!agv)
            return std::unexpected(agv.error());
        tag.agv = *agv;
        return tag;
    }
    if (column == Height) {
        const auto mm = CellInput::number(input, tr("the height of %1 in mm").arg(name), -mostCoordinate_mm,
                                          mostCoordinate_mm);
        if (!mm)
            return std::unexpected(mm.error());
        tag.z_m = metresFromMm(*mm);
        return tag;
    }
    const auto id = CellInput::wholeNumber(input, tr("the number of %1").arg(name), 0, mostUwbNumber);
    if (!id)
        return std::unexpected(id.error());
    const auto other = std::ranges::find(m_settings.tags, *id, &UwbTag::id);
    if (other != m_settings.tags.end() && other - m_settings.tags.begin() != row) {
        return failure(ErrorCode::BadInput, tr("There is a UWB tag %1 already (%2): choose another number.")
                                                .arg(*id)
                                                .arg(uwbTagName(*other))
                                                .toStdString());
    }
    tag.id = *id;
    return tag;
}

bool UwbTagTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid) ||
        !flags(index).testFlag(Qt::ItemIsEditable))
        return false;
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    const QString input = value.toString();
    if (input == index.data(Qt::EditRole).toString())
        return true;
    Result<UwbTag> edited = changed(index.row(), index.column(), input);
    if (!edited) {
        emit refused(QString::fromStdString(edited.error().detail));
        return false;
    }
    if (*edited == row.tag)
        return true;
    std::vector<UwbTag> tags = m_settings.tags;
    const QString name = uwbTagName(row.tag);
    if (row.listed) {
        tags[static_cast<std::size_t>(index.row())] = *edited;
        emit editRequested(tr("Edit %1").arg(name), tags);
    } else {
        if (edited->label.empty())
            edited->label = "T" + std::to_string(edited->id); // as the plant file would
        tags.push_back(*edited);
        emit editRequested(tr("List %1").arg(name), tags);
    }
    return true;
}

Qt::ItemFlags UwbTagTableModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (!index.isValid() || !isEditable(index.column()))
        return flags;
    const bool listed = m_rows[static_cast<std::size_t>(index.row())].listed;
    if (listed || index.column() != Id) // the number of a tag that is heard is what it says
        flags |= Qt::ItemIsEditable;
    return flags;
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
