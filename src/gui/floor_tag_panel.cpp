// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/floor_tag_panel.h"

#include "gui/cell_delegates.h"
#include "ui_floor_tag_panel.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>
#include <QSettings>
#include <QSortFilterProxyModel>

#include <optional>

namespace agv::gui {

using model::FloorTagState;
using model::FloorTagTableModel;

namespace {

constexpr auto hiddenColumnsKey = "floorTags/hiddenColumns";

QString csvField(const QString& text)
{
    const bool quoted = text.contains(QLatin1Char(',')) || text.contains(QLatin1Char('"'));
    return quoted ? QLatin1Char('"') + QString(text).replace(QLatin1Char('"'), QStringLiteral("\"\"")) +
                        QLatin1Char('"')
                  : text;
}

} // namespace

/// Rows whose text holds the words typed, in a chosen state.
class FloorTagFilter : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setText(const QString& text)
    {
        m_text = text.trimmed();
        invalidateFilter();
    }
    void setState(std::optional<FloorTagState> state)
    {
        m_state = state;
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override
    {
        const auto at = [&](int column) { return sourceModel()->index(row, column, parent); };
        if (m_state && at(0).data(FloorTagTableModel::StateRole).toInt() != static_cast<int>(*m_state))
            return false;
        if (m_text.isEmpty())
            return true;
        for (const int column : {FloorTagTableModel::Number, FloorTagTableModel::Short,
                                 FloorTagTableModel::Uid, FloorTagTableModel::Robot}) {
            if (at(column).data().toString().contains(m_text, Qt::CaseInsensitive))
                return true;
        }
        return false;
    }

private:
    QString m_text;
    std::optional<FloorTagState> m_state;
};

FloorTagPanel::FloorTagPanel(QWidget* parent)
    : QWidget(parent),
      m_ui(std::make_unique<Ui::FloorTagPanel>()),
      m_shown(new FloorTagFilter(this))
{
    m_ui->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
    auto* table = m_ui->floorTagTable;
    m_states = new WarningDelegate(FloorTagTableModel::WarningRole, table);
    m_shown->setSourceModel(&m_tags);
    m_shown->setSortRole(FloorTagTableModel::SortRole);
    table->setModel(m_shown);
    table->setItemDelegateForColumn(FloorTagTableModel::State, m_states);
    table->setSortingEnabled(true);
    table->sortByColumn(FloorTagTableModel::Number, Qt::AscendingOrder);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->verticalHeader()->hide();
    table->horizontalHeader()->setStretchLastSection(true);
    const char* const samples[] = {"Number 00",   "Short 0",      "E004015000000000W",
                                   "-000,000 mm", "-000,000 mm",  "Frueher gelesen",
                                   "Gelesen von", "RSSI, Stufen", "00 min"};
    for (int column = 0; column < FloorTagTableModel::ColumnCount; ++column)
        table->setColumnWidth(column, fontMetrics().horizontalAdvance(QLatin1String(samples[column])) + 22);
    table->horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
    restoreColumns();
    fillStates();
    connect(table->horizontalHeader(), &QWidget::customContextMenuRequested, this,
            &FloorTagPanel::chooseColumns);
    connect(m_ui->columnsButton, &QToolButton::clicked, this, [this] { chooseColumns(QPoint(0, 0)); });
    connect(m_ui->filterEdit, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_shown->setText(text);
        updateHint();
    });
    connect(m_ui->stateCombo, &QComboBox::currentIndexChanged, this, [this] {
        const QVariant state = m_ui->stateCombo->currentData();
        m_shown->setState(state.isValid() ? std::optional(static_cast<FloorTagState>(state.toInt()))
                                          : std::nullopt);
        updateHint();
    });
    connect(m_ui->copyCsvButton, &QToolButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(csv()); });
    connect(table, &QAbstractItemView::activated, this, [this](const QModelIndex& index) {
        emit placeChosen(m_tags.placeOf(m_shown->mapToSource(index).row()));
    });
    updateHint();
}

FloorTagPanel::~FloorTagPanel() = default;

void FloorTagPanel::setPlant(const PlantLayout& plant)
{
    m_tags.setTags(plant.floorTags);
    updateHint();
}

void FloorTagPanel::setTheme(const Theme& theme)
{
    m_states->setTheme(theme);
    m_ui->floorTagTable->viewport()->update();
}

void FloorTagPanel::showSnapshot(const PlantSnapshot& snapshot) { m_tags.setSnapshot(snapshot); }

void FloorTagPanel::fillStates()
{
    const int chosen = std::max(0, m_ui->stateCombo->currentIndex());
    m_ui->stateCombo->clear();
    m_ui->stateCombo->addItem(tr("All"));
    for (const FloorTagState state : {FloorTagState::SeenNow, FloorTagState::SeenBefore,
                                      FloorTagState::NotSeen, FloorTagState::Missing, FloorTagState::Unknown})
        m_ui->stateCombo->addItem(FloorTagTableModel::stateText(state), static_cast<int>(state));
    m_ui->stateCombo->setCurrentIndex(chosen);
}

void FloorTagPanel::updateHint()
{
    m_ui->floorTagTable->setHint(
        m_tags.rowCount() == 0
            ? tr("The plant file names no floor tags. Add a grid or a list of surveyed tags to it.")
            : tr("No floor tag fits the filter."));
}

void FloorTagPanel::chooseColumns(QPoint at)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    auto* table = m_ui->floorTagTable;
    for (int column = 0; column < FloorTagTableModel::ColumnCount; ++column) {
        QAction* action =
            menu->addAction(m_tags.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
        action->setCheckable(true);
        action->setChecked(!table->isColumnHidden(column));
        action->setEnabled(column != FloorTagTableModel::Short); // something has to name the row
        connect(action, &QAction::toggled, this, [table, column](bool on) {
            table->setColumnHidden(column, !on);
            QStringList hidden;
            for (int i = 0; i < FloorTagTableModel::ColumnCount; ++i) {
                if (table->isColumnHidden(i))
                    hidden << QString::number(i);
            }
            QSettings().setValue(QLatin1String(hiddenColumnsKey), hidden);
        });
    }
    menu->popup(table->horizontalHeader()->mapToGlobal(at));
}

void FloorTagPanel::restoreColumns()
{
    for (const QString& column : QSettings().value(QLatin1String(hiddenColumnsKey)).toStringList()) {
        const int index = column.toInt();
        if (index >= 0 && index < FloorTagTableModel::ColumnCount && index != FloorTagTableModel::Short)
            m_ui->floorTagTable->setColumnHidden(index, true);
    }
}

QString FloorTagPanel::csv() const
{
    QString text = QStringLiteral("number,uid,x_mm,y_mm,state,read_by,rssi\n");
    for (int row = 0; row < m_shown->rowCount(); ++row) {
        const auto at = [&](int column) { return m_shown->index(row, column); };
        const Point2 place = m_tags.placeOf(m_shown->mapToSource(at(0)).row());
        const bool isRead = at(FloorTagTableModel::Rssi).data(FloorTagTableModel::SortRole).toInt() >= 0;
        const QStringList fields{
            at(FloorTagTableModel::Number).data(FloorTagTableModel::SortRole).toString(),
            at(FloorTagTableModel::Uid).data().toString(),
            QString::number(1e3 * place.x, 'f', 1),
            QString::number(1e3 * place.y, 'f', 1),
            at(FloorTagTableModel::State).data().toString(),
            isRead ? at(FloorTagTableModel::Robot).data(FloorTagTableModel::SortRole).toString() : QString(),
            isRead ? at(FloorTagTableModel::Rssi).data().toString() : QString()};
        QStringList quoted;
        for (const QString& field : fields)
            quoted << csvField(field);
        text += quoted.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return text;
}

void FloorTagPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        m_ui->retranslateUi(this);
        fillStates();
        updateHint();
    }
    QWidget::changeEvent(event);
}

} // namespace agv::gui
