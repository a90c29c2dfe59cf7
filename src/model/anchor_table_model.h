// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/plant_layout.h"
#include "core/uwb_snapshot.h"

#include <vector>

namespace agv::model {

/// "A0", or "Anchor 0" where the list has no label.
QString anchorName(const UwbAnchor& anchor);

/// The UWB anchors of the plant: where they stand, and how their ranges fit. GUI thread. Lengths in mm.
/// Cells are edited, but an edit is only asked for: the owner of the list answers with setAnchors(), so that
/// every change passes through its undo.
class AnchorTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Id, Label, X, Y, Z, Shown, Age, Rate, Residual, Spread, Warning, ColumnCount };
    enum Role { WarningRole = Qt::UserRole }; ///< bool, the cell needs attention

    explicit AnchorTableModel(QObject* parent = nullptr);

    void setAnchors(const std::vector<UwbAnchor>& anchors);
    const std::vector<UwbAnchor>& anchors() const { return m_anchors; }
    /// Null: nothing is known of the unit.
    void setSnapshot(const UwbSnapshot* uwb);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    /// True when the input is good; it stands in the table after the answer to editRequested().
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    /// `what` names the edit for the undo list.
    void editRequested(const QString& what, const std::vector<agv::UwbAnchor>& anchors);
    /// Input that cannot be used; a sentence in the language of the program.
    void refused(const QString& sentence);

private:
    const UwbAnchorSnapshot* live(int row) const;
    QString text(int row, int column) const;
    QString editText(int row, int column) const;
    QString toolTip(int row, int column) const;
    /// The anchor with the cell's new value; the reason when it does not fit.
    Result<UwbAnchor> changed(int row, int column, const QString& input) const;

    std::vector<UwbAnchor> m_anchors;
    std::vector<UwbAnchorSnapshot> m_live; ///< by row; an entry of another id stands for none
};

} // namespace agv::model
