// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/links_panel.h"

#include "gui/cell_delegates.h"
#include "gui/glyphs.h"
#include "ui_links_panel.h"

#include <QEvent>
#include <QHeaderView>

#include <algorithm>
#include <map>

namespace agv::gui {

using model::LinkTableModel;
using model::VehicleTableModel;

LinksPanel::LinksPanel(QWidget* parent) : QWidget(parent), m_ui(std::make_unique<Ui::LinksPanel>())
{
    m_ui->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
    auto* links = m_ui->linkTable;
    links->setModel(&m_links);
    links->setItemDelegate(new LinkDelegate(links));
    links->setSelectionMode(QAbstractItemView::ExtendedSelection);
    links->verticalHeader()->setDefaultSectionSize(2 * fontMetrics().height() + 8);
    QHeaderView* header = links->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(LinkTableModel::Connection, QHeaderView::Stretch);

    auto* vehicles = m_ui->vehicleTable;
    vehicles->setModel(&m_vehicles);
    vehicles->setItemDelegate(new WarningDelegate(VehicleTableModel::WarningRole, vehicles));
    vehicles->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    vehicles->horizontalHeader()->setSectionResizeMode(VehicleTableModel::State, QHeaderView::Stretch);
    m_ui->refusedLabel->hide();
    m_ui->readingLabel->hide();
    m_ui->portButton->hide();

    connect(m_ui->openButton, &QPushButton::clicked, this, [this] {
        if (isUwbChosen())
            emit openUwbRequested();
        for (int robot : chosenRobots())
            emit openReaderRequested(robot);
    });
    connect(m_ui->closeButton, &QPushButton::clicked, this, [this] {
        if (isUwbChosen())
            emit closeUwbRequested();
        for (int robot : chosenRobots())
            emit closeReaderRequested(robot);
    });
    connect(m_ui->portButton, &QPushButton::clicked, this, &LinksPanel::uwbPortRequested);
    connect(m_ui->readButton, &QPushButton::toggled, this, &LinksPanel::read);
    connect(links->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &LinksPanel::updateButtons);
    retranslate();
}

LinksPanel::~LinksPanel() = default;

void LinksPanel::setTheme(const Theme& theme)
{
    m_theme = theme;
    static_cast<LinkDelegate*>(m_ui->linkTable->itemDelegate())->setTheme(theme);
    static_cast<WarningDelegate*>(m_ui->vehicleTable->itemDelegate())->setTheme(theme);
    m_ui->linkTable->viewport()->update();
    m_ui->vehicleTable->viewport()->update();
}

void LinksPanel::showSnapshot(const PlantSnapshot& snapshot)
{
    m_links.setSnapshot(snapshot);
    if (static_cast<std::size_t>(m_vehicles.rowCount()) != snapshot.agvs.size()) {
        m_vehicles.setSnapshot(snapshot);
        // As tall as its rows, up to eight: what is left belongs to the connections.
        const auto* table = m_ui->vehicleTable;
        const int rows = std::clamp(m_vehicles.rowCount(), 2, 8);
        m_ui->vehicleTable->setFixedHeight(table->horizontalHeader()->sizeHint().height() +
                                           rows * table->verticalHeader()->defaultSectionSize() + 4);
    }
    m_vehicles.setSnapshot(snapshot);
    m_agvs = snapshot.agvs;
    showReading();
    if (snapshot.refusedPeers != m_refused) {
        m_refused = snapshot.refusedPeers;
        retranslate();
    }
    updateButtons();
}

std::vector<int> LinksPanel::chosenRobots() const
{
    const QModelIndexList rows = m_ui->linkTable->selectionModel()->selectedRows();
    std::vector<int> robots;
    for (const QModelIndex& index : rows)
        robots.push_back(index.data(LinkTableModel::RobotRole).toInt());
    if (robots.empty()) {
        for (int row = 0; row < m_links.rowCount(); ++row)
            robots.push_back(m_links.index(row, 0).data(LinkTableModel::RobotRole).toInt());
    }
    std::erase(robots, 0); // the UWB unit
    std::sort(robots.begin(), robots.end());
    robots.erase(std::unique(robots.begin(), robots.end()), robots.end());
    return robots;
}

bool LinksPanel::isUwbChosen() const
{
    const QModelIndexList rows = m_ui->linkTable->selectionModel()->selectedRows();
    return rows.size() == 1 &&
           rows.front().data(LinkTableModel::KindRole).toInt() == static_cast<int>(LinkTableModel::Kind::Uwb);
}

/// Whether the buttons are for the link of this row.
bool LinksPanel::isChosen(const QModelIndex& row) const
{
    const auto kind = static_cast<LinkTableModel::Kind>(row.data(LinkTableModel::KindRole).toInt());
    if (isUwbChosen() || kind != LinkTableModel::Kind::Reader)
        return isUwbChosen() && kind == LinkTableModel::Kind::Uwb;
    const std::vector<int> robots = chosenRobots();
    return std::find(robots.begin(), robots.end(), row.data(LinkTableModel::RobotRole).toInt()) !=
           robots.end();
}

void LinksPanel::read(bool on)
{
    for (int robot : on ? chosenRobots() : std::vector<int>{}) {
        const auto agv = std::find_if(m_agvs.begin(), m_agvs.end(),
                                      [robot](const AgvSnapshot& a) { return a.id.number == robot; });
        if (agv != m_agvs.end() && agv->readerLink.state == LinkState::Down)
            emit openReaderRequested(robot);
    }
    showReading();
}

void LinksPanel::showReading()
{
    const bool on = m_ui->readButton->isChecked();
    m_ui->readingLabel->setVisible(on);
    if (!on)
        return;
    const std::vector<int> robots = chosenRobots();
    QStringList lines;
    for (const AgvSnapshot& agv : m_agvs) {
        if (std::find(robots.begin(), robots.end(), agv.id.number) != robots.end())
            lines << readingOf(agv);
    }
    m_ui->readingLabel->setText(lines.join(QLatin1Char('\n')));
}

QString LinksPanel::readingOf(const AgvSnapshot& agv) const
{
    std::map<TagUid, int> rssi; // by tag, so that the line stands still
    for (const TagRead& read : agv.recentReads)
        rssi[read.uid] = read.rssi;
    if (rssi.empty())
        return tr("AGV %1 reads no floor tag").arg(agv.id.number);
    QStringList tags;
    for (const auto& [uid, value] : rssi)
        tags << QStringLiteral("%1 (%2)").arg(QString::fromStdString(shortText(uid))).arg(value);
    return tr("AGV %1 reads tag (RSSI): %2").arg(agv.id.number).arg(tags.join(QStringLiteral(", ")));
}

void LinksPanel::updateButtons()
{
    bool canOpen = false;
    bool canClose = false;
    for (int row = 0; row < m_links.rowCount(); ++row) {
        if (!isChosen(m_links.index(row, 0)))
            continue;
        const LinkState state = m_links.link(row).state;
        canOpen = canOpen || state == LinkState::Down || state == LinkState::Failed;
        canClose = canClose || state != LinkState::Down;
    }
    m_ui->openButton->setEnabled(canOpen);
    m_ui->closeButton->setEnabled(canClose);
    const bool uwb = isUwbChosen();
    m_ui->readButton->setVisible(!uwb);
    m_ui->portButton->setVisible(uwb);
    m_ui->openButton->setText(uwb ? tr("&Open UWB") : tr("&Open RFID"));
    m_ui->closeButton->setText(uwb ? tr("&Close UWB") : tr("&Close RFID"));
    m_ui->openButton->setToolTip(
        uwb ? tr("Open the serial port of the UWB unit")
            : tr("Open the RFID reader of the chosen row; with none chosen, all readers"));
    m_ui->closeButton->setToolTip(
        uwb ? tr("Close the serial port of the UWB unit")
            : tr("Close the RFID reader of the chosen row; with none chosen, all readers"));
}

void LinksPanel::retranslate()
{
    const QString hint = tr("No AGVs. The plant file names none; add them there and start again.");
    m_ui->linkTable->setHint(hint);
    m_ui->vehicleTable->setHint(hint);
    QStringList peers;
    for (const std::string& peer : m_refused)
        peers << QString::fromStdString(peer);
    m_ui->refusedLabel->setText(
        tr("Refused, not in the plant file: %1").arg(peers.join(QStringLiteral(", "))));
    m_ui->refusedLabel->setVisible(!peers.isEmpty());
}

void LinksPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        m_ui->retranslateUi(this);
        retranslate();
        updateButtons();
    }
    QWidget::changeEvent(event);
}

} // namespace agv::gui
