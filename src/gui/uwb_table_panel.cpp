// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/uwb_table_panel.h"

#include "gui/choice_delegate.h"
#include "gui/dialog_parts.h"
#include "gui/hint_table_view.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace agv::gui {

UwbTablePanel::UwbTablePanel(QWidget* parent)
    : QWidget(parent),
      m_bar(new QToolBar),
      m_table(new HintTableView),
      m_noteRow(new QWidget),
      m_noteIcon(new QLabel),
      m_note(new QLabel)
{
    setAttribute(Qt::WA_StyledBackground);
    m_bar->setObjectName(QStringLiteral("uwbBar"));
    m_bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                             QAbstractItemView::AnyKeyPressed);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    const int rowHeight = m_table->verticalHeader()->defaultSectionSize();
    m_table->setMinimumHeight(rowHeight + 10); // on a small screen a note takes the place of a row
    m_note->setWordWrap(true);
    m_note->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_note->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    auto* noteLayout = new QHBoxLayout(m_noteRow);
    noteLayout->setContentsMargins(4, 0, 4, 0);
    noteLayout->addWidget(m_noteIcon);
    noteLayout->addWidget(m_note, 1);
    m_noteRow->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 4);
    layout->setSpacing(4);
    layout->addWidget(m_bar);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_noteRow);
}

void UwbTablePanel::setActions(const QList<QAction*>& actions)
{
    m_bar->addActions(actions);
    // Qt's own sign for actions that found no room is drawn for light windows.
    if (auto* more = m_bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
        more->setToolButtonStyle(Qt::ToolButtonTextOnly);
        more->setText(QChar(0x00BB));
    }
}

void UwbTablePanel::useDelegate(int warningRole, int choicesRole)
{
    m_delegate = new ChoiceDelegate(warningRole, choicesRole, m_table);
    m_table->setItemDelegate(m_delegate);
}

void UwbTablePanel::setTheme(const Theme& theme)
{
    m_theme = theme;
    if (m_delegate)
        m_delegate->setTheme(theme);
    m_table->viewport()->update();
    showNote();
}

void UwbTablePanel::setNote(const QString& text, bool isWarning)
{
    m_note->setText(text);
    m_isWarning = isWarning;
    m_noteRow->setVisible(!text.isEmpty());
    showNote();
}

void UwbTablePanel::showNote()
{
    showStatusGlyph(*m_noteIcon, m_isWarning ? Glyph::Warning : Glyph::Info, m_theme);
}

std::vector<int> UwbTablePanel::chosenRows() const
{
    std::vector<int> rows;
    if (!m_table->selectionModel())
        return rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        rows.push_back(index.row());
    std::ranges::sort(rows);
    return rows;
}

} // namespace agv::gui
