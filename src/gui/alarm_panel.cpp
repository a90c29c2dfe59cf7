// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/alarm_panel.h"

#include "gui/cell_delegates.h"
#include "ui_alarm_panel.h"

#include <QApplication>
#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QSettings>

#include <algorithm>

namespace agv::gui {

using model::AlarmTableModel;

namespace {

constexpr auto soundKey = "alarms/sound";
constexpr double shelfMinutes[] = {10.0, 60.0, 480.0};

bool isNew(const AlarmSnapshot& alarm)
{
    return alarm.state == AlarmState::Unacknowledged || alarm.state == AlarmState::Returned;
}
bool isShelved(const AlarmSnapshot& alarm) { return alarm.state == AlarmState::Shelved; }
bool mayBeShelved(const AlarmSnapshot& alarm)
{
    return alarm.state != AlarmState::Shelved && alarm.priority != AlarmPriority::High;
}

} // namespace

AlarmPanel::AlarmPanel(QWidget* parent) : QWidget(parent), m_ui(std::make_unique<Ui::AlarmPanel>())
{
    m_ui->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
    auto* table = m_ui->alarmTable;
    table->setModel(&m_alarms);
    table->setItemDelegateForColumn(AlarmTableModel::Priority, new AlarmPriorityDelegate(table));
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setWordWrap(true);
    table->verticalHeader()->hide();
    QHeaderView* header = table->horizontalHeader();
    header->setStretchLastSection(false);
    header->setSectionResizeMode(AlarmTableModel::Text, QHeaderView::Stretch);
    const auto room = [this](const QString& text) { return fontMetrics().horizontalAdvance(text) + 22; };
    header->resizeSection(AlarmTableModel::Priority, room(QStringLiteral("Medium")) + 24);
    header->resizeSection(AlarmTableModel::Time, room(QStringLiteral("00:00:00")));
    header->resizeSection(AlarmTableModel::Source, room(QStringLiteral("Anchor 00")));
    header->resizeSection(AlarmTableModel::State, room(QStringLiteral("Shelved, 59 min left")));
    connect(header, &QHeaderView::sectionResized, this, [this](int section) {
        if (section == AlarmTableModel::Text)
            QMetaObject::invokeMethod(this, &AlarmPanel::fitRows, Qt::QueuedConnection);
    });
    table->setHint(tr("No alarms: nothing asks for you."));
    buildShelfMenu();
    m_ui->floodLabel->hide();
    m_ui->soundBox->setChecked(QSettings().value(QLatin1String(soundKey), false).toBool());
    connect(m_ui->soundBox, &QCheckBox::toggled, this,
            [](bool on) { QSettings().setValue(QLatin1String(soundKey), on); });
    connect(m_ui->acknowledgeButton, &QPushButton::clicked, this, &AlarmPanel::acknowledge);
    connect(m_ui->unshelveButton, &QPushButton::clicked, this, [this] {
        if (const std::vector<AlarmKey> keys = chosen(isShelved); !keys.empty())
            emit unshelveRequested(keys);
    });
    connect(table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &AlarmPanel::updateButtons);
    updateButtons();
}

AlarmPanel::~AlarmPanel() = default;

void AlarmPanel::buildShelfMenu()
{
    auto* menu = new QMenu(m_ui->shelveButton);
    const QString texts[] = {tr("For 10 minutes"), tr("For 1 hour"), tr("For the shift, 8 hours")};
    for (std::size_t i = 0; i < std::size(texts); ++i) {
        QAction* action = menu->addAction(texts[i]);
        action->setObjectName(QStringLiteral("shelve%1Action").arg(shelfMinutes[i]));
        connect(action, &QAction::triggered, this, [this, i] {
            if (const std::vector<AlarmKey> keys = chosen(mayBeShelved); !keys.empty())
                emit shelveRequested(keys, 60.0 * shelfMinutes[i]);
        });
    }
    delete m_ui->shelveButton->menu();
    m_ui->shelveButton->setMenu(menu);
}

void AlarmPanel::setTheme(const Theme& theme)
{
    static_cast<AlarmPriorityDelegate*>(m_ui->alarmTable->itemDelegateForColumn(AlarmTableModel::Priority))
        ->setTheme(theme);
    m_ui->alarmTable->viewport()->update();
}

void AlarmPanel::showSnapshot(const PlantSnapshot& snapshot)
{
    const int rowsBefore = m_alarms.rowCount();
    m_alarms.setAlarms(snapshot.alarms);
    m_ui->floodLabel->setVisible(snapshot.alarmFlood);
    if (m_alarms.rowCount() != rowsBefore)
        fitRows();
    updateButtons();
    const int before = std::exchange(m_newCount, m_alarms.newCount());
    if (m_newCount <= before)
        return;
    if (m_ui->soundBox->isChecked())
        QApplication::beep();
    emit alarmCame();
}

void AlarmPanel::acknowledge()
{
    std::vector<AlarmKey> keys = chosen(isNew);
    if (keys.empty() && !m_ui->alarmTable->selectionModel()->hasSelection()) {
        for (const AlarmSnapshot& alarm : m_alarms.alarms()) {
            if (isNew(alarm))
                keys.push_back(alarm.key);
        }
    }
    if (!keys.empty())
        emit acknowledgeRequested(keys);
}

std::vector<AlarmKey> AlarmPanel::chosen(bool (*fits)(const AlarmSnapshot&)) const
{
    std::vector<AlarmKey> keys;
    for (const QModelIndex& row : m_ui->alarmTable->selectionModel()->selectedRows()) {
        const AlarmSnapshot& alarm = m_alarms.alarms()[static_cast<std::size_t>(row.row())];
        if (fits(alarm))
            keys.push_back(alarm.key);
    }
    return keys;
}

void AlarmPanel::updateButtons()
{
    const bool any = m_ui->alarmTable->selectionModel()->hasSelection();
    m_ui->acknowledgeButton->setEnabled(any ? !chosen(isNew).empty()
                                            : std::ranges::any_of(m_alarms.alarms(), isNew));
    m_ui->shelveButton->setEnabled(!chosen(mayBeShelved).empty());
    m_ui->unshelveButton->setEnabled(!chosen(isShelved).empty());
}

void AlarmPanel::fitRows() { m_ui->alarmTable->resizeRowsToContents(); }

void AlarmPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        m_ui->retranslateUi(this);
        m_ui->alarmTable->setHint(tr("No alarms: nothing asks for you."));
        buildShelfMenu();
    }
    QWidget::changeEvent(event);
}

} // namespace agv::gui
