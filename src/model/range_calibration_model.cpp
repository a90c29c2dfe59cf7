// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/range_calibration_model.h"

#include "core/units.h"
#include "model/anchor_table_model.h"
#include "model/cell_input.h"

#include <algorithm>
#include <optional>

namespace agv::model {
namespace {

template<typename Corrections>
auto findPair(Corrections& corrections, int anchor, int tag)
{
    return std::ranges::find_if(corrections, [anchor, tag](const RangeCorrection& correction) {
        return correction.anchor == anchor && correction.tag == tag;
    });
}

QString centimetres(std::optional<double> metres)
{
    return metres ? CellInput::shown(mmFromMetres(*metres) / mmPerCm, 1) : CellInput::none();
}

} // namespace

RangeCalibrationModel::RangeCalibrationModel(QObject* parent) : QAbstractTableModel(parent) {}

void RangeCalibrationModel::setResult(const std::vector<UwbAnchor>& anchors,
                                      const std::vector<RangeCorrection>& corrections,
                                      const RangeCalibrationSnapshot& calibration)
{
    const bool reset = calibration.rows.size() != m_result.rows.size();
    if (reset)
        beginResetModel();
    m_anchors = anchors;
    m_corrections = corrections;
    m_result = calibration;
    if (reset)
        endResetModel();
    else if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void RangeCalibrationModel::clear()
{
    beginResetModel();
    m_result = {};
    endResetModel();
}

int RangeCalibrationModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_result.rows.size());
}

int RangeCalibrationModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString RangeCalibrationModel::text(const RangeCalibrationRow& row, int column) const
{
    switch (column) {
    case Anchor: {
        const auto anchor = std::ranges::find(m_anchors, row.anchor, &UwbAnchor::id);
        return anchor == m_anchors.end() ? tr("Anchor %1").arg(row.anchor) : anchorName(*anchor);
    }
    case Count:
        return CellInput::shown(row.count, 0);
    case Present: {
        const auto present = findPair(m_corrections, row.anchor, m_result.tag);
        return centimetres(present == m_corrections.end() ? std::nullopt : std::optional(present->offset_m));
    }
    case Found:
        return centimetres(row.offset_m);
    case Spread:
        return row.count > 1 ? CellInput::shown(mmFromMetres(row.spread_m), 0) : CellInput::none();
    default:
        return {};
    }
}

QVariant RangeCalibrationModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const RangeCalibrationRow& row = m_result.rows[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole)
        return text(row, index.column());
    if (role == Qt::ToolTipRole && index.column() == Found && !row.offset_m)
        return tr("Too few ranges: its correction stays as it is");
    if (role == Qt::TextAlignmentRole)
        return headerData(index.column(), Qt::Horizontal, role);
    return {};
}

QVariant RangeCalibrationModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::Alignment(section == Anchor ? Qt::AlignLeft | Qt::AlignVCenter
                                                                   : Qt::AlignRight | Qt::AlignVCenter));
    if (role == Qt::ToolTipRole && section == Spread)
        return tr("Standard deviation of a single range");
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Anchor:
        return tr("Anchor");
    case Count:
        return tr("Ranges");
    case Present:
        return tr("Now (cm)");
    case Found:
        return tr("Found (cm)");
    case Spread:
        return tr("Spread (mm)");
    default:
        return {};
    }
}

std::vector<RangeCorrection> corrected(std::vector<RangeCorrection> corrections,
                                       const RangeCalibrationSnapshot& calibration)
{
    for (const RangeCalibrationRow& row : calibration.rows) {
        if (!row.offset_m)
            continue;
        const RangeCorrection found{row.anchor, calibration.tag, *row.offset_m};
        if (const auto present = findPair(corrections, row.anchor, calibration.tag);
            present != corrections.end())
            *present = found;
        else
            corrections.push_back(found);
    }
    return corrections;
}

} // namespace agv::model
