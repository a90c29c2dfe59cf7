// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

#include "core/snapshot.h"
#include "gui/theme.h"

namespace agv::gui {

/// Paints a connection's cells: two lines where the model has a detail, the state with its shape.
class LinkDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit LinkDelegate(QObject* parent = nullptr) : QStyledItemDelegate(parent) {}
    void setTheme(const Theme& theme) { m_theme = theme; }
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    Theme m_theme = Theme::light();
};

/// Paints a cell whose bool role `warningRole` is set with a warning sign and the warning colour.
class WarningDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    WarningDelegate(int warningRole, QObject* parent) : QStyledItemDelegate(parent), m_role(warningRole) {}
    void setTheme(const Theme& theme) { m_theme = theme; }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
    int m_role;
    Theme m_theme = Theme::light();
};

/// Paints the level of an event with its shape; colour for warnings and errors only.
class EventLevelDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit EventLevelDelegate(QObject* parent = nullptr) : QStyledItemDelegate(parent) {}
    void setTheme(const Theme& theme) { m_theme = theme; }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
    Theme m_theme = Theme::light();
};

/// Paints the priority of an alarm with its shape, bold while nobody has acknowledged it.
class AlarmPriorityDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit AlarmPriorityDelegate(QObject* parent = nullptr) : QStyledItemDelegate(parent) {}
    void setTheme(const Theme& theme) { m_theme = theme; }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

private:
    Theme m_theme = Theme::light();
};

QColor colourOf(AlarmPriority priority, const Theme& theme);
QColor colourOf(LinkState state, const Theme& theme);

} // namespace agv::gui
