// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

#include "gui/theme.h"

#include <vector>

class QAction;
class QLabel;
class QToolBar;

namespace agv::gui {

class ChoiceDelegate;
class HintTableView;

/// A table of the UWB kit: its actions above, and below a line for what the operator has to know.
class UwbTablePanel : public QWidget {
    Q_OBJECT
public:
    explicit UwbTablePanel(QWidget* parent = nullptr);

    HintTableView* table() { return m_table; }
    void setActions(const QList<QAction*>& actions);
    /// Cells with the roles of ChoiceDelegate.
    void useDelegate(int warningRole, int choicesRole);
    void setTheme(const Theme& theme);
    /// Empty: no line. A warning has a sign before it.
    void setNote(const QString& text, bool isWarning);
    /// Rows that are chosen, rising.
    std::vector<int> chosenRows() const;

private:
    void showNote();

    QToolBar* m_bar;
    HintTableView* m_table;
    QWidget* m_noteRow;
    QLabel* m_noteIcon;
    QLabel* m_note;
    ChoiceDelegate* m_delegate = nullptr;
    Theme m_theme = Theme::light();
    bool m_isWarning = false;
};

} // namespace agv::gui
