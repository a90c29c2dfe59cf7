// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/cell_delegates.h"

#include "gui/glyphs.h"
#include "model/alarm_table_model.h"
#include "model/event_table_model.h"
#include "model/link_table_model.h"

#include <QApplication>
#include <QPainter>

namespace agv::gui {

using model::LinkTableModel;

namespace {

constexpr int cellPadding = 5;
constexpr int glyphSide = 14;

QFont smallFont(QFont font)
{
    font.setPointSizeF(font.pointSizeF() * 0.88);
    return font;
}

} // namespace

QColor colourOf(LinkState state, const Theme& theme)
{
    switch (state) {
    case LinkState::Up:
    case LinkState::Opening:
        return theme.text;
    case LinkState::Down:
        return theme.mutedText;
    case LinkState::Silent:
    case LinkState::Waiting:
        return theme.warning;
    case LinkState::Failed:
        return theme.error;
    }
    return theme.text;
}

void LinkDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const
{
    QStyleOptionViewItem background(option);
    initStyleOption(&background, index);
    const QString text = background.text;
    background.text.clear();
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &background, painter, option.widget);

    const auto state = static_cast<LinkState>(index.data(LinkTableModel::LinkStateRole).toInt());
    const QString detail = index.data(LinkTableModel::DetailRole).toString();
    const bool isState = index.column() == LinkTableModel::State;
    QRect area = option.rect.adjusted(cellPadding, 0, -cellPadding, 0);
    painter->save();
    if (isState) {
        const QRect icon(area.left(), area.top() + (area.height() - glyphSide) / 2, glyphSide, glyphSide);
        paintGlyph(*painter, icon, glyphOf(state), colourOf(state, m_theme));
        area.setLeft(icon.right() + 7);
    }
    const QColor colour = isState                                         ? colourOf(state, m_theme)
                          : state == LinkState::Up || index.column() == 0 ? m_theme.text
                                                                          : m_theme.mutedText;
    const QFontMetrics metrics(option.font);
    const QFont second = smallFont(option.font);
    const QFontMetrics secondMetrics(second);
    const int height = metrics.height() + (detail.isEmpty() ? 0 : secondMetrics.height());
    QRect line(area.left(), area.top() + (area.height() - height) / 2, area.width(), metrics.height());
    painter->setFont(option.font);
    painter->setPen(colour);
    painter->drawText(line, static_cast<int>(background.displayAlignment),
                      metrics.elidedText(text, Qt::ElideRight, line.width()));
    if (!detail.isEmpty()) {
        line = QRect(line.left(), line.bottom() + 1, line.width(), secondMetrics.height());
        painter->setFont(second);
        painter->setPen(m_theme.mutedText);
        painter->drawText(line, static_cast<int>(background.displayAlignment),
                          secondMetrics.elidedText(detail, Qt::ElideRight, line.width()));
    }
    painter->restore();
}

QSize LinkDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const QFontMetrics metrics(option.font);
    const QFontMetrics secondMetrics(smallFont(option.font));
    const int text = metrics.horizontalAdvance(index.data().toString());
    const int detail = secondMetrics.horizontalAdvance(index.data(LinkTableModel::DetailRole).toString());
    const int icon = index.column() == LinkTableModel::State ? glyphSide + 7 : 0;
    return {std::max(text, detail) + 2 * cellPadding + icon + 2,
            metrics.height() + secondMetrics.height() + 8};
}

void WarningDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    if (!index.data(m_role).toBool())
        return;
    option->palette.setColor(QPalette::Text, m_theme.warning);
    option->palette.setColor(QPalette::HighlightedText, m_theme.warning);
    option->icon = glyphIcon(Glyph::Warning, m_theme.warning, m_theme.warning);
    option->decorationSize = QSize(glyphSide, glyphSide);
    option->features |= QStyleOptionViewItem::HasDecoration;
}

void EventLevelDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    const auto level = static_cast<EventLevel>(index.data(model::EventTableModel::LevelRole).toInt());
    const QColor colour = level == EventLevel::Error     ? m_theme.error
                          : level == EventLevel::Warning ? m_theme.warning
                                                         : m_theme.mutedText;
    option->palette.setColor(QPalette::Text, colour);
    option->palette.setColor(QPalette::HighlightedText, colour);
    option->icon = glyphIcon(glyphOf(level), colour, colour);
    option->decorationSize = QSize(glyphSide, glyphSide);
    option->features |= QStyleOptionViewItem::HasDecoration;
}

QColor colourOf(AlarmPriority priority, const Theme& theme)
{
    switch (priority) {
    case AlarmPriority::High:
        return theme.error;
    case AlarmPriority::Medium:
        return theme.warning;
    case AlarmPriority::Low:
        break;
    }
    return theme.text;
}

void AlarmPriorityDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    const auto priority =
        static_cast<AlarmPriority>(index.data(model::AlarmTableModel::PriorityRole).toInt());
    const auto state = static_cast<AlarmState>(index.data(model::AlarmTableModel::StateRole).toInt());
    const bool isNew = state == AlarmState::Unacknowledged || state == AlarmState::Returned;
    const QColor colour = state == AlarmState::Shelved ? m_theme.mutedText : colourOf(priority, m_theme);
    option->palette.setColor(QPalette::Text, colour);
    option->palette.setColor(QPalette::HighlightedText, colour);
    option->font.setBold(isNew);
    option->icon = glyphIcon(glyphOf(priority), colour, colour);
    option->decorationSize = QSize(glyphSide, glyphSide);
    option->features |= QStyleOptionViewItem::HasDecoration;
}

} // namespace agv::gui
