// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/shortcut_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace agv::gui {
namespace {

QLabel* keyLabel(const QString& keys)
{
    auto* label = new QLabel(keys);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

} // namespace

ShortcutDialog::ShortcutDialog(const QList<QAction*>& actions, QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("Keyboard shortcuts"));
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(24);
    const auto keys = [](QKeySequence sequence) { return sequence.toString(QKeySequence::NativeText); };
    form->addRow(keyLabel(keys(Qt::Key_Escape) + QStringLiteral(", ") + keys(Qt::Key_Pause)),
                 new QLabel(tr("Stop all AGVs, from everywhere")));
    for (const QAction* action : actions) {
        // The AGVs have one line together.
        if (action->shortcut().isEmpty() || action->property("agv").isValid())
            continue;
        QString text = action->text();
        form->addRow(keyLabel(keys(action->shortcut())), new QLabel(text.remove(QLatin1Char('&'))));
    }
    form->addRow(keyLabel(keys(QKeySequence(Qt::ALT | Qt::Key_1)) + QStringLiteral(" … ") + keys(Qt::Key_9)),
                 new QLabel(tr("Choose AGV 1 to 9")));
    form->addRow(keyLabel(tr("Arrows, +, -")), new QLabel(tr("Move and zoom the map that has the focus")));
    form->addRow(keyLabel(keys(QKeySequence::Copy)),
                 new QLabel(tr("Copy the chosen lines of the event log")));
    form->addRow(keyLabel(keys(Qt::Key_Tab)), new QLabel(tr("Go to the next field")));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setText(tr("Close")); // Qt's own translations may be missing
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 18, 20, 14);
    layout->setSpacing(16);
    layout->addLayout(form);
    layout->addWidget(buttons);
}

} // namespace agv::gui
