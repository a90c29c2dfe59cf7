// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/anchor_table_model.h"

#include "core/units.h"
#include "model/cell_input.h"
#include "model/messages.h"
#include "model/words.h"

#include <algorithm>

namespace agv::model {
namespace {

bool isNumber(int column) { return column != AnchorTableModel::Label && column != AnchorTableModel::Warning; }

double& coordinate(UwbAnchor& anchor, int column)
{
    if (column == AnchorTableModel::X)
        return anchor.x;
    return column == AnchorTableModel::Y ? anchor.y : anchor.z;
}

double coordinate(const UwbAnchor& anchor, int column)
{
    UwbAnchor copy = anchor;
    return coordinate(copy, column);
}

} // namespace

QString anchorName(const UwbAnchor& anchor)
{
    return anchor.label.empty() ? AnchorTableModel::tr("Anchor %1").arg(anchor.id)
                                : QString::fromStdString(anchor.label);
}

AnchorTableModel::AnchorTableModel(QObject* parent) : QAbstractTableModel(parent) {}

void AnchorTableModel::setAnchors(const std::vector<UwbAnchor>& anchors)
{
    if (anchors.size() != m_anchors.size()) {
        beginResetModel();
        m_anchors = anchors;
        m_live.resize(m_anchors.size());
        endResetModel();
        return;
    }
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        if (anchors[i] == m_anchors[i])
            continue;
        m_anchors[i] = anchors[i];
        const int row = static_cast<int>(i);
        emit dataChanged(index(row, 0), index(row, ColumnCount - 1));
    }
}

void AnchorTableModel::setSnapshot(const UwbSnapshot* uwb)
{
    for (std::size_t i = 0; i < m_anchors.size(); ++i) {
        UwbAnchorSnapshot now;
        now.id = -1;
        if (uwb) {
            const auto heard = std::ranges::find(uwb->anchors, m_anchors[i].id, &UwbAnchorSnapshot::id);
            if (heard != uwb->anchors.end())
                now = *heard;
        }
        if (now == m_live[i])
            continue;
        m_live[i] = std::move(now);
        const int row = static_cast<int>(i);
        emit dataChanged(index(row, Age), index(row, Warning));
    }
}

const UwbAnchorSnapshot* AnchorTableModel::live(int row) const
{
    const auto i = static_cast<std::size_t>(row);
    return m_live[i].id == m_anchors[i].id ? &m_live[i] : nullptr;
}

int AnchorTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_anchors.size());
}

int AnchorTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString AnchorTableModel::text(int row, int column) const
{
    const UwbAnchor& anchor = m_anchors[static_cast<std::size_t>(row)];
    const UwbAnchorSnapshot* heard = live(row);
    switch (column) {
    case Id:
        return QString::number(anchor.id);
    case Label:
        return QString::fromStdString(anchor.label);
    case X:
    case Y:
    case Z:
        return CellInput::shown(mmFromMetres(coordinate(anchor, column)), 0);
    case Age:
        return heard && heard->age_s ? Words::age(*heard->age_s) : CellInput::none();
    case Rate:
        return heard && heard->age_s ? CellInput::shown(heard->rangesPerSecond, 1) : CellInput::none();
    case Residual:
        return heard && heard->residual ? CellInput::shown(mmFromMetres(heard->residual->mean_m), 0)
                                        : CellInput::none();
    case Spread:
        return heard && heard->residual ? CellInput::shown(mmFromMetres(heard->residual->sd_m), 0)
                                        : CellInput::none();
    case Warning:
        return heard ? Messages::sentence(heard->warning) : QString();
    default:
        return {};
    }
}

QString AnchorTableModel::editText(int row, int column) const
{
    const UwbAnchor& anchor = m_anchors[static_cast<std::size_t>(row)];
    if (column >= X && column <= Z)
        return CellInput::editable(mmFromMetres(coordinate(anchor, column)));
    return text(row, column);
}

QString AnchorTableModel::toolTip(int row, int column) const
{
    const UwbAnchor& anchor = m_anchors[static_cast<std::size_t>(row)];
    const UwbAnchorSnapshot* heard = live(row);
    if (column == Warning && heard && !heard->warning.empty())
        return text(row, Warning);
    if ((column == Residual || column == Spread) && heard && heard->residual)
        return tr("Of the last %1 ranges of %2").arg(heard->residual->count).arg(anchorName(anchor));
    if (column >= Age && (!heard || !heard->age_s))
        return tr("No range of %1 yet: open the UWB unit and switch a tag on").arg(anchorName(anchor));
    if (column == Residual || column == Spread)
        return tr("Too few ranges of %1 with a position yet").arg(anchorName(anchor));
    return headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
}

QVariant AnchorTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const UwbAnchor& anchor = m_anchors[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return text(index.row(), index.column());
    case Qt::EditRole:
        return editText(index.row(), index.column());
    case Qt::CheckStateRole:
        return index.column() == Shown ? QVariant(anchor.shown ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return toolTip(index.row(), index.column());
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::Alignment(
            isNumber(index.column()) ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter));
    case WarningRole:
        return index.column() == Warning && !text(index.row(), Warning).isEmpty();
    default:
        return {};
    }
}

Result<UwbAnchor> AnchorTableModel::changed(int row, int column, const QString& input) const
{
    UwbAnchor anchor = m_anchors[static_cast<std::size_t>(row)];
    const QString name = anchorName(anchor);
    if (column == Label) {
        anchor.label = input.trimmed().toStdString();
        return anchor;
    }
    if (column == Id) {
        const auto id = CellInput::wholeNumber(input, tr("the number of %1").arg(name), 0, mostUwbNumber);
        if (!id)
            return std::unexpected(id.error());
        const auto other = std::ranges::find(m_anchors, *id, &UwbAnchor::id);
        if (other != m_anchors.end() && other - m_anchors.begin() != row) {
            return failure(ErrorCode::BadInput,
                           tr("There is an anchor %1 already (%2): choose another number.")
                               .arg(*id)
                               .arg(anchorName(*other))
                               .toStdString());
        }
        anchor.id = *id;
        return anchor;
    }
    const QString axis = column == X   ? QStringLiteral("x")
                         : column == Y ? QStringLiteral("y")
                                       : QStringLiteral("z");
    const auto mm =
        CellInput::number(input, tr("%1 of %2 in mm").arg(axis, name), -mostCoordinate_mm, mostCoordinate_mm);
    if (!mm)
        return std::unexpected(mm.error());
    coordinate(anchor, column) = metresFromMm(*mm);
    return anchor;
}

bool AnchorTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || index.column() > Shown)
        return false;
    std::vector<UwbAnchor> anchors = m_anchors;
    UwbAnchor& anchor = anchors[static_cast<std::size_t>(index.row())];
    const QString name = anchorName(anchor);
    if (index.column() == Shown) {
        if (role != Qt::CheckStateRole)
            return false;
        anchor.shown = value.toInt() == Qt::Checked;
        emit editRequested(anchor.shown ? tr("Show %1").arg(name) : tr("Hide %1").arg(name), anchors);
        return true;
    }
    if (role != Qt::EditRole)
        return false;
    const QString input = value.toString();
    if (input == editText(index.row(), index.column()))
        return true;
    const Result<UwbAnchor> edited = changed(index.row(), index.column(), input);
    if (!edited) {
        emit refused(QString::fromStdString(edited.error().detail));
        return false;
    }
    if (*edited == anchor)
        return true;
    anchor = *edited;
    emit editRequested(index.column() >= X    ? tr("Move %1").arg(name)
                       : index.column() == Id ? tr("Renumber %1").arg(name)
                                              : tr("Rename %1").arg(name),
                       anchors);
    return true;
}

Qt::ItemFlags AnchorTableModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (!index.isValid())
        return flags;
    if (index.column() == Shown)
        flags |= Qt::ItemIsUserCheckable;
    else if (index.column() < Shown)
        flags |= Qt::ItemIsEditable;
    return flags;
}

QVariant AnchorTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::Alignment(isNumber(section) ? Qt::AlignRight | Qt::AlignVCenter
                                                                   : Qt::AlignLeft | Qt::AlignVCenter));
    const auto choose = [role](const QString& title, const QString& tip) {
        return role == Qt::DisplayRole   ? QVariant(title)
               : role == Qt::ToolTipRole ? QVariant(tip)
                                         : QVariant();
    };
    switch (section) {
    case Id:
        return choose(tr("No.", "number of an anchor"),
                      tr("Number of the anchor, as in the reports: 0 to 255"));
    case Label:
        return choose(tr("Anchor"), tr("Name on the map and in messages"));
    case X:
        return choose(tr("x (mm)"), tr("Antenna of the anchor, to the east of the plant's origin"));
    case Y:
        return choose(tr("y (mm)"), tr("Antenna of the anchor, to the north of the plant's origin"));
    case Z:
        return choose(tr("z (mm)"), tr("Height of the anchor's antenna above the floor"));
    case Shown:
        return choose(tr("Map"), tr("Whether the map shows the anchor; its ranges are used in any case"));
    case Age:
        return choose(tr("Age"), tr("Time since the last range"));
    case Rate:
        return choose(tr("Rate (1/s)"), tr("Ranges per second, of all tags"));
    case Residual:
        return choose(
            tr("Residual (mm)"),
            tr("How much longer its ranges are than the distances to the positions, on average. Far from 0: "
               "it stands elsewhere, its view is blocked, or its ranges need a correction"));
    case Spread:
        return choose(tr("Spread (mm)"), tr("Standard deviation of the residuals"));
    case Warning:
        return choose(tr("Notice"), tr("Why the place of the anchor in the list is doubted"));
    default:
        return {};
    }
}

} // namespace agv::model
