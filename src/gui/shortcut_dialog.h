// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QAction;

namespace agv::gui {

/// The list of keys, made from the actions themselves so that it cannot go stale.
class ShortcutDialog : public QDialog {
    Q_OBJECT
public:
    ShortcutDialog(const QList<QAction*>& actions, QWidget* parent);
};

} // namespace agv::gui
