// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hint_table_view.h"

#include <QHeaderView>
#include <QPainter>

namespace agv::gui {

HintTableView::HintTableView(QWidget* parent) : QTableView(parent)
{
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setShowGrid(false);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false); // Tab leaves the table; the arrows move in it
    setWordWrap(false);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    verticalHeader()->setMinimumSectionSize(fontMetrics().height() + 4);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setMinimumSectionSize(24);
}

QSize HintTableView::sizeHint() const
{
    const QSize size = QTableView::sizeHint();
    return {size.width(), minimumHeight() > 0 ? minimumHeight() : size.height()};
}

void HintTableView::setHint(const QString& hint)
{
    m_hint = hint;
    setAccessibleDescription(hint);
    viewport()->update();
}

bool HintTableView::showsHint() const { return !m_hint.isEmpty() && (!model() || model()->rowCount() == 0); }

void HintTableView::paintEvent(QPaintEvent* event)
{
    QTableView::paintEvent(event);
    if (!showsHint())
        return;
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect().adjusted(16, 8, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, m_hint);
}

} // namespace agv::gui
