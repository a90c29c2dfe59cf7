// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/correction_dialog.h"

#include "gui/hint_table_view.h"
#include "gui/uwb_editor.h"
#include "gui/uwb_table_panel.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace agv::gui {

CorrectionDialog::CorrectionDialog(UwbEditor& editor, QWidget* parent)
    : QDialog(parent),
      m_editor(editor),
      m_panel(new UwbTablePanel)
{
    setWindowTitle(tr("Correction table"));
    auto* intro =
        new QLabel(tr("Added to each measured range, in cm. A range that reads too long needs a negative "
                      "correction. An empty cell adds nothing."));
    intro->setWordWrap(true);
    intro->setProperty("role", QStringLiteral("muted"));
    HintTableView* table = m_panel->table();
    table->setObjectName(QStringLiteral("correctionTable"));
    table->setAccessibleName(tr("Range corrections"));
    table->setModel(&m_model);
    table->setSelectionBehavior(QAbstractItemView::SelectItems);
    table->verticalHeader()->show();
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    const auto addAction = [this](const QString& text, const char* name) {
        auto* action = new QAction(text, this);
        action->setObjectName(QString::fromLatin1(name));
        return action;
    };
    QAction* undo = addAction(tr("Undo"), "undoCorrectionAction");
    QAction* redo = addAction(tr("Redo"), "redoCorrectionAction");
    undo->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
    redo->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
    m_panel->setActions({undo, redo});
    QUndoStack& stack = editor.undoStack();
    undo->setEnabled(stack.canUndo());
    redo->setEnabled(stack.canRedo());
    connect(&stack, &QUndoStack::canUndoChanged, undo, &QAction::setEnabled);
    connect(&stack, &QUndoStack::canRedoChanged, redo, &QAction::setEnabled);
    connect(undo, &QAction::triggered, &stack, &QUndoStack::undo);
    connect(redo, &QAction::triggered, &stack, &QUndoStack::redo);
    connect(&m_model, &model::CorrectionTableModel::editRequested, &editor, &UwbEditor::setCorrections);
    connect(&m_model, &model::CorrectionTableModel::refused, this,
            [this](const QString& sentence) { m_panel->setNote(sentence, true); });
    connect(&editor, &UwbEditor::edited, this, [this] {
        m_panel->setNote({}, false);
        update();
    });
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addWidget(m_panel, 1);
    layout->addWidget(buttons);
    resize(620, 380);
    update();
}

void CorrectionDialog::setTheme(const Theme& theme)
{
    setPalette(theme.toPalette());
    m_panel->setTheme(theme);
}

void CorrectionDialog::showUwb(const UwbSnapshot* uwb)
{
    std::vector<int> heard;
    if (uwb) {
        for (const UwbTagSnapshot& tag : uwb->tags)
            heard.push_back(tag.id);
    }
    if (heard == m_heard)
        return;
    m_heard = heard;
    update();
}

void CorrectionDialog::update()
{
    m_model.setSettings(m_editor.anchors(), m_editor.settings(), m_heard);
    m_panel->table()->setHint(
        m_editor.anchors().empty()
            ? tr("No corrections: there are no anchors. Add them in the panel UWB anchors.")
            : tr("No corrections: no tag is listed or heard. Add one in the panel UWB tags, or "
                 "switch one on."));
}

} // namespace agv::gui
