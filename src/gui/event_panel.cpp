// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/event_panel.h"

#include "gui/cell_delegates.h"
#include "gui/glyphs.h"
#include "ui_event_panel.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QScrollBar>
#include <QSortFilterProxyModel>

#include <algorithm>

namespace agv::gui {

using model::EventTableModel;

/// Leaves out the details.
class EventFilter : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setDetails(bool on)
    {
        m_details = on;
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override
    {
        return m_details || sourceModel()->index(row, 0, parent).data(EventTableModel::LevelRole).toInt() !=
                                static_cast<int>(EventLevel::Detail);
    }

private:
    bool m_details = false;
};

EventPanel::EventPanel(QWidget* parent)
    : QWidget(parent),
      m_ui(std::make_unique<Ui::EventPanel>()),
      m_shown(new EventFilter(this))
{
    m_ui->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
    auto* table = m_ui->table;
    m_shown->setSourceModel(&m_events);
    table->setModel(m_shown);
    table->setItemDelegateForColumn(EventTableModel::Level, new EventLevelDelegate(table));
    QHeaderView* header = table->horizontalHeader();
    header->setStretchLastSection(true);
    // A long text takes a second line rather than being cut off.
    table->setWordWrap(true);
    connect(header, &QHeaderView::sectionResized, this, [this](int section) {
        if (section == EventTableModel::Text)
            QMetaObject::invokeMethod(this, &EventPanel::fitRows, Qt::QueuedConnection);
    });
    header->resizeSection(EventTableModel::Time,
                          fontMetrics().horizontalAdvance(QStringLiteral("00:00:00")) + 18);
    header->resizeSection(EventTableModel::Level,
                          fontMetrics().horizontalAdvance(QStringLiteral("Warnung")) + 38);
    header->resizeSection(EventTableModel::Source,
                          fontMetrics().horizontalAdvance(QStringLiteral("RFID reader 10")) + 18);
    auto* copyAction = new QAction(this);
    copyAction->setShortcut(QKeySequence::Copy);
    copyAction->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(copyAction);
    connect(copyAction, &QAction::triggered, this, &EventPanel::copy);
    connect(m_ui->detailsButton, &QToolButton::toggled, this, &EventPanel::showDetails);
    connect(m_ui->copyButton, &QToolButton::clicked, this, &EventPanel::copy);
    followNewest();
    table->setHint(tr("Nothing has happened yet. Connections, turns and errors are written here."));
}

EventPanel::~EventPanel() = default;

void EventPanel::setTheme(const Theme& theme)
{
    static_cast<EventLevelDelegate*>(m_ui->table->itemDelegateForColumn(EventTableModel::Level))
        ->setTheme(theme);
    m_ui->copyButton->setIcon(glyphIcon(Glyph::Copy, theme.text, theme.disabledText));
    m_ui->detailsButton->setIcon(glyphIcon(Glyph::Info, theme.text, theme.disabledText));
    m_ui->table->viewport()->update();
}

void EventPanel::addEvent(const EventEntry& event)
{
    m_events.append(event);
    fitRow(m_shown->rowCount() - 1);
}

QString EventPanel::selectedText() const
{
    std::vector<int> rows;
    for (const QModelIndex& index : m_ui->table->selectionModel()->selectedRows())
        rows.push_back(m_shown->mapToSource(index).row());
    if (rows.empty()) {
        for (int row = 0; row < m_shown->rowCount(); ++row)
            rows.push_back(m_shown->mapToSource(m_shown->index(row, 0)).row());
    }
    std::sort(rows.begin(), rows.end());
    QString text;
    for (int row : rows)
        text += m_events.rowText(row) + QLatin1Char('\n');
    return text;
}

void EventPanel::fitRow(int row)
{
    auto* table = m_ui->table;
    const QModelIndex text = m_shown->index(row, EventTableModel::Text);
    const int room = table->columnWidth(EventTableModel::Text) - 16;
    if (table->fontMetrics().horizontalAdvance(text.data().toString()) > room)
        table->resizeRowToContents(row);
    else
        table->setRowHeight(row, table->verticalHeader()->defaultSectionSize());
}

void EventPanel::fitRows()
{
    for (int row = 0; row < m_shown->rowCount(); ++row)
        fitRow(row);
}

void EventPanel::followNewest()
{
    QScrollBar* bar = m_ui->table->verticalScrollBar();
    connect(bar, &QScrollBar::valueChanged, this,
            [this, bar](int value) { m_following = value == bar->maximum(); });
    // More lines, taller lines or a smaller table: none of them is the operator scrolling up.
    connect(bar, &QScrollBar::rangeChanged, this, [this, bar](int, int maximum) {
        if (m_following)
            bar->setValue(maximum);
    });
}

void EventPanel::showDetails(bool on)
{
    m_shown->setDetails(on);
    fitRows();
}

void EventPanel::copy() const { QGuiApplication::clipboard()->setText(selectedText()); }

void EventPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        m_ui->retranslateUi(this);
        m_ui->table->setHint(tr("Nothing has happened yet. Connections, turns and errors are written here."));
    }
    QWidget::changeEvent(event);
}

} // namespace agv::gui
