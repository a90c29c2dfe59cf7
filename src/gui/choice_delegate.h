// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gui/cell_delegates.h"

namespace agv::gui {

/// WarningDelegate whose cells are edited by a list where the model has one (role `choicesRole`,
/// QStringList), else by a line of text that the model reads.
class ChoiceDelegate : public WarningDelegate {
    Q_OBJECT
public:
    ChoiceDelegate(int warningRole, int choicesRole, QObject* parent)
        : WarningDelegate(warningRole, parent),
          m_choicesRole(choicesRole)
    {}
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

private:
    int m_choicesRole;
};

} // namespace agv::gui
