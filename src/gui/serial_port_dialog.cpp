// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/serial_port_dialog.h"

#include "gui/choice_box.h"
#include "gui/dialog_parts.h"
#include "gui/hint_table_view.h"
#include "model/messages.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <algorithm>

namespace agv::gui {
namespace {

enum Column { Port, Description, Usb, SerialNumber, ColumnCount };

const SerialPortChoice anyTrekUnit{.path = {}, .usb = trekUsbId, .serialNumber = {}};

bool isTrek(const SerialPortInfo& port) { return port.usb == trekUsbId; }

QString dialectName(UwbDialect dialect)
{
    switch (dialect) {
    case UwbDialect::Trek:
        return SerialPortDialog::tr("trek (TREK1000, firmware 2.x)");
    case UwbDialect::TrekOld:
        return SerialPortDialog::tr("trek-1.06 (TREK1000, firmware 1.06)");
    case UwbDialect::UlmFour:
        return SerialPortDialog::tr("ulm4 (ULM1, LD600)");
    case UwbDialect::UlmEight:
        return SerialPortDialog::tr("ulm8 (ULM3)");
    case UwbDialect::Esp32:
        return SerialPortDialog::tr("esp32 (as trek, without a time)");
    case UwbDialect::Imu:
        return SerialPortDialog::tr("imu (metres, motion sensors)");
    case UwbDialect::Unknown:
        break;
    }
    return SerialPortDialog::tr("found from what the unit writes");
}

} // namespace

SerialPortDialog::SerialPortDialog(const SerialPortChoice& port, std::optional<UwbDialect> dialect,
                                   QWidget* parent)
    : QDialog(parent),
      m_present(port),
      m_model(new QStandardItemModel(this)),
      m_table(new HintTableView),
      m_path(new QLineEdit(QString::fromStdString(port.path))),
      m_dialect(new ChoiceBox),
      m_none(new QLabel(tr("This computer has no serial port now. Plug the unit in, then list again."))),
      m_unit(new QLabel),
      m_ask(new QPushButton(tr("&Ask the unit"))),
      m_use(new QPushButton(tr("&Use this port")))
{
    setWindowTitle(tr("Port of the UWB unit"));
    buildFields();
    m_dialect->setCurrentIndex(m_dialect->findData(static_cast<int>(dialect.value_or(UwbDialect::Unknown))));
    auto* refresh = new QPushButton(tr("&List again"));
    refresh->setObjectName(QStringLiteral("listPortsButton"));
    refresh->setToolTip(tr("Look again which serial ports this computer has"));
    auto* close = new QPushButton(tr("&Close"));
    close->setToolTip(tr("Close; the port stays as it is"));
    for (QPushButton* button : {refresh, close, m_ask})
        button->setAutoDefault(false);
    m_use->setDefault(true);
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("Or another &path"), m_path);
    form->addRow(tr("&Dialect"), m_dialect);
    centreLabels(*form);
    auto* unit = new QHBoxLayout;
    unit->addWidget(m_unit, 1);
    unit->addWidget(m_ask);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(refresh);
    buttons->addStretch();
    buttons->addWidget(m_use);
    buttons->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_none);
    layout->addLayout(form);
    layout->addLayout(unit);
    layout->addLayout(buttons);
    connect(refresh, &QPushButton::clicked, this, &SerialPortDialog::portsRequested);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_use, &QPushButton::clicked, this, &SerialPortDialog::accept);
    connect(m_ask, &QPushButton::clicked, this, &SerialPortDialog::askRequested);
    resize(640, 420);
    fillPorts();
    showUwb(nullptr);
}

void SerialPortDialog::buildFields()
{
    m_table->setObjectName(QStringLiteral("portTable"));
    m_table->setAccessibleName(tr("Serial ports"));
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setModel(m_model);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_path->setObjectName(QStringLiteral("portPathEdit"));
    m_path->setPlaceholderText(m_present.path.empty() ? QString::fromStdString(toText(m_present))
                                                      : QStringLiteral("/dev/ttyACM0"));
    m_path->setToolTip(tr("Any name the system opens; a choice in the list fills it in"));
    for (std::size_t i = 0; i < uwbDialectCount; ++i)
        m_dialect->addItem(dialectName(static_cast<UwbDialect>(i)), static_cast<int>(i));
    m_dialect->setObjectName(QStringLiteral("dialectCombo"));
    m_dialect->setToolTip(tr("How the unit writes its reports; choose one only when it is found wrongly"));
    m_none->setObjectName(QStringLiteral("noPortsLabel"));
    m_none->setWordWrap(true);
    m_none->hide();
    m_unit->setObjectName(QStringLiteral("unitLabel"));
    m_unit->setWordWrap(true);
    m_ask->setObjectName(QStringLiteral("askUnitButton"));
    m_ask->setToolTip(tr("Ask the unit for its version, number and radio channel"));
    m_use->setObjectName(QStringLiteral("usePortButton"));
    m_use->setToolTip(tr("Use this port and dialect from now on; Undo takes it back"));
    m_use->setProperty("primary", true);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &SerialPortDialog::onRowChosen);
    connect(m_table, &QTableView::doubleClicked, this, &SerialPortDialog::accept);
    // A path that is typed is chosen, whatever row was.
    connect(m_path, &QLineEdit::textEdited, this, [this] { m_table->selectionModel()->clear(); });
}

void SerialPortDialog::setTheme(const Theme& theme)
{
    m_theme = theme;
    setPalette(theme.toPalette());
}

void SerialPortDialog::showPorts(std::vector<SerialPortInfo> ports)
{
    std::ranges::stable_partition(ports, isTrek);
    m_ports = std::move(ports);
    m_none->setVisible(m_ports.empty());
    fillPorts();
}

void SerialPortDialog::fillPorts()
{
    const SerialPortChoice before = choice();
    m_model->clear();
    m_model->setHorizontalHeaderLabels({tr("Port"), tr("Device"), tr("USB ID"), tr("Serial number")});
    const auto addRow = [this](const QStringList& texts) {
        QList<QStandardItem*> items;
        for (const QString& text : texts)
            items << new QStandardItem(text);
        m_model->appendRow(items);
    };
    addRow({tr("any"), tr("The first TREK1000 unit that is plugged in"),
            QString::fromStdString(toText(trekUsbId)), tr("any")});
    for (const SerialPortInfo& port : m_ports) {
        addRow({QString::fromStdString(port.path), QString::fromStdString(port.description),
                port.usb ? QString::fromStdString(toText(*port.usb)) : QString(),
                QString::fromStdString(port.serialNumber)});
    }
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(Description, QHeaderView::Stretch);
    const auto present = std::ranges::find(m_ports, before.path, &SerialPortInfo::path);
    if (before == anyTrekUnit || before == SerialPortChoice{})
        m_table->selectRow(0);
    else if (present != m_ports.end())
        m_table->selectRow(1 + static_cast<int>(present - m_ports.begin()));
}

void SerialPortDialog::onRowChosen()
{
    const int row = m_table->currentIndex().row();
    if (row >= 0)
        m_path->setText(row == 0 ? QString()
                                 : QString::fromStdString(m_ports[static_cast<std::size_t>(row - 1)].path));
}

SerialPortChoice SerialPortDialog::choice() const
{
    const std::string path = m_path->text().trimmed().toStdString();
    if (path.empty() && m_table->currentIndex().row() == 0)
        return anyTrekUnit;
    if (path == m_present.path)
        return m_present;
    const auto port = std::ranges::find(m_ports, path, &SerialPortInfo::path);
    return {.path = path, .usb = port == m_ports.end() ? std::nullopt : port->usb, .serialNumber = {}};
}

std::optional<UwbDialect> SerialPortDialog::dialect() const
{
    const auto dialect = static_cast<UwbDialect>(m_dialect->currentData().toInt());
    return dialect == UwbDialect::Unknown ? std::nullopt : std::optional(dialect);
}

QString SerialPortDialog::unitText(const UwbSnapshot* uwb) const
{
    if (!uwb || !isConnected(uwb->link))
        return tr("The unit is not connected: choose its port, then open it in the panel Links.");
    if (!uwb->unit) {
        return uwb->unitNote.empty() ? tr("The unit has not told yet what it is.")
                                     : model::Messages::sentence(uwb->unitNote);
    }
    const UwbConfiguration& unit = uwb->unit->configuration;
    return tr("Unit: %1, number %2, channel %3, %4")
        .arg(QString::fromStdString(uwb->unit->version))
        .arg(unit.address)
        .arg(unit.channel)
        .arg(unit.fastMode ? tr("6.81 Mb/s") : tr("110 kb/s"));
}

void SerialPortDialog::showUwb(const UwbSnapshot* uwb)
{
    m_unit->setText(unitText(uwb));
    m_ask->setEnabled(uwb && isConnected(uwb->link));
}

void SerialPortDialog::accept()
{
    emit chosen(choice(), dialect());
    QDialog::accept();
}

} // namespace agv::gui
