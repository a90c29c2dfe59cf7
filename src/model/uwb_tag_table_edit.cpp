// SPDX-License-Identifier: GPL-3.0-or-later
// What UwbTagTableModel takes as input.
#include "core/units.h"
#include "model/cell_input.h"
#include "model/uwb_tag_table_model.h"

#include <algorithm>

namespace agv::model {
namespace {

bool isEditable(int column) { return column <= UwbTagTableModel::Height; }

} // namespace

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

} // namespace agv::model
