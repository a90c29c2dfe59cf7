// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/correction_table_model.h"

#include "core/units.h"
#include "model/anchor_table_model.h"
#include "model/cell_input.h"
#include "model/uwb_tag_table_model.h"

#include <algorithm>
#include <set>

namespace agv::model {
namespace {

std::vector<UwbTag> allTags(const UwbSettings& settings, const std::vector<int>& heard)
{
    std::set<int> ids(heard.begin(), heard.end());
    for (const UwbTag& tag : settings.tags)
        ids.insert(tag.id);
    for (const RangeCorrection& correction : settings.corrections)
        ids.insert(correction.tag);
    std::vector<UwbTag> tags;
    for (int id : ids) {
        const auto listed = std::ranges::find(settings.tags, id, &UwbTag::id);
        tags.push_back(listed == settings.tags.end()
                           ? UwbTag{.id = id, .label = {}, .agv = {}, .z_m = 0.0, .mount = {}}
                           : *listed);
    }
    return tags;
}

} // namespace

CorrectionTableModel::CorrectionTableModel(QObject* parent) : QAbstractTableModel(parent) {}

void CorrectionTableModel::setSettings(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings,
                                       const std::vector<int>& heard)
{
    std::vector<UwbTag> tags = allTags(settings, heard);
    if (anchors == m_anchors && tags == m_tags) {
        if (settings.corrections == m_corrections)
            return;
        m_corrections = settings.corrections;
        if (rowCount() > 0 && columnCount() > 0)
            emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
        return;
    }
    beginResetModel();
    m_anchors = anchors;
    m_tags = std::move(tags);
    m_corrections = settings.corrections;
    endResetModel();
}

int CorrectionTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() || m_tags.empty() ? 0 : static_cast<int>(m_anchors.size());
}

int CorrectionTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_tags.size());
}

const RangeCorrection* CorrectionTableModel::correction(const QModelIndex& index) const
{
    const int anchor = m_anchors[static_cast<std::size_t>(index.row())].id;
    const int tag = m_tags[static_cast<std::size_t>(index.column())].id;
    const auto found = std::ranges::find_if(m_corrections, [anchor, tag](const RangeCorrection& correction) {
        return correction.anchor == anchor && correction.tag == tag;
    });
    return found == m_corrections.end() ? nullptr : &*found;
}

QString CorrectionTableModel::pairName(const QModelIndex& index) const
{
    return tr("%1 – %2", "anchor and tag")
        .arg(anchorName(m_anchors[static_cast<std::size_t>(index.row())]),
             uwbTagName(m_tags[static_cast<std::size_t>(index.column())]));
}

QVariant CorrectionTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const RangeCorrection* found = correction(index);
    switch (role) {
    case Qt::DisplayRole:
        return found ? CellInput::shown(mmFromMetres(found->offset_m) / mmPerCm, 1) : CellInput::none();
    case Qt::EditRole:
        return found ? CellInput::editable(mmFromMetres(found->offset_m) / mmPerCm) : QString();
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return tr("%1: added to each measured range, in cm; empty: nothing").arg(pairName(index));
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    default:
        return {};
    }
}

bool CorrectionTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return false;
    const QString input = value.toString().trimmed();
    if (input == data(index, Qt::EditRole).toString())
        return true;
    const bool removed = input.isEmpty() || input == CellInput::none();
    RangeCorrection edited{m_anchors[static_cast<std::size_t>(index.row())].id,
                           m_tags[static_cast<std::size_t>(index.column())].id, 0.0};
    if (!removed) {
        const auto cm =
            CellInput::number(input, tr("the correction %1 in cm").arg(pairName(index)), -most_cm, most_cm);
        if (!cm) {
            emit refused(QString::fromStdString(cm.error().detail));
            return false;
        }
        edited.offset_m = metresFromMm(*cm * mmPerCm);
    }
    const RangeCorrection* present = correction(index);
    if (present ? !removed && *present == edited : removed)
        return true;
    std::vector<RangeCorrection> corrections = m_corrections;
    if (!present)
        corrections.push_back(edited);
    else if (const auto place = corrections.begin() + (present - m_corrections.data()); removed)
        corrections.erase(place);
    else
        *place = edited;
    emit editRequested(tr("Correct %1").arg(pairName(index)), corrections);
    return true;
}

Qt::ItemFlags CorrectionTableModel::flags(const QModelIndex& index) const
{
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.isValid() ? flags | Qt::ItemIsEditable : flags;
}

QVariant CorrectionTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    const auto i = static_cast<std::size_t>(section);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::Alignment(orientation == Qt::Horizontal
                                                     ? Qt::AlignRight | Qt::AlignVCenter
                                                     : Qt::AlignLeft | Qt::AlignVCenter));
    if (role != Qt::DisplayRole || section < 0)
        return {};
    if (orientation == Qt::Horizontal)
        return i < m_tags.size() ? tr("%1 (cm)", "correction of this tag").arg(uwbTagName(m_tags[i]))
                                 : QVariant();
    return i < m_anchors.size() ? anchorName(m_anchors[i]) : QVariant();
}

} // namespace agv::model
