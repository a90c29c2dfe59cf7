// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "gui/serial_port_dialog.h"
#include "gui/uwb_fixture.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

using namespace agv;
using namespace agv::gui;

/// Choice of the serial port of the UWB unit.
class SerialPortDialogTest : public UwbFixture {
    Q_OBJECT
private slots:
    void portsAreListedWithTheKitsFirst();
    void aPortOrAnyUnitOrATypedPathIsChosenWithUndo();
    void theDialectIsFoundOrChosen();
    void theUnitIsAskedAndItsAnswerShown();
    void thePortIsChosenFromTheRowOfTheUnit();

private:
    std::vector<SerialPortInfo> ports() const
    {
        return {{"/dev/ttyS0", "", {}, ""},
                {"/dev/ttyUSB0", "CP2102", UsbId{0x10c4, 0xea60}, "0001"},
                {"/dev/ttyACM1", "STM32 Virtual COM Port", trekUsbId, "3061"}};
    }
};

void SerialPortDialogTest::portsAreListedWithTheKitsFirst()
{
    openRunning();
    QSignalSpy requests(m_window.get(), &MainWindow::serialPortsRequested);
    trigger("uwbPortAction");
    QCOMPARE(requests.count(), 1);
    m_window->showSerialPorts(ports());
    QCOMPARE(cell("portTable", 0, 0), QStringLiteral("any"));
    QCOMPARE(cell("portTable", 1, 0), QStringLiteral("/dev/ttyACM1"));
    QCOMPARE(cell("portTable", 1, 1), QStringLiteral("STM32 Virtual COM Port"));
    QCOMPARE(cell("portTable", 1, 2), QStringLiteral("0483:5740"));
    QCOMPARE(cell("portTable", 1, 3), QStringLiteral("3061"));
    QCOMPARE(cell("portTable", 2, 0), QStringLiteral("/dev/ttyS0"));
    click("listPortsButton");
    QCOMPARE(requests.count(), 2);
    QVERIFY(!find<QLabel>("noPortsLabel")->isVisible());
    m_window->showSerialPorts({});
    QVERIFY(find<QLabel>("noPortsLabel")->isVisible());
}

void SerialPortDialogTest::aPortOrAnyUnitOrATypedPathIsChosenWithUndo()
{
    openRunning();
    const PlantLayout plant = scenes::uwbPlant();
    QList<SerialPortChoice> choices;
    connect(m_window.get(), &MainWindow::uwbPortChosen, this,
            [&choices](const SerialPortChoice& port, std::optional<UwbDialect>) { choices << port; });
    const auto choose = [this](const auto& act) {
        trigger("uwbPortAction");
        m_window->showSerialPorts(ports());
        act();
        click("usePortButton");
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    };
    choose([this] { find<HintTableView>("portTable")->selectRow(1); });
    QVERIFY((choices.back() == SerialPortChoice{"/dev/ttyACM1", trekUsbId, ""}));
    QVERIFY(m_edited.back().second.port == choices.back());
    QVERIFY(undoes(plant.anchors, plant.uwb));
    choose([this] { find<HintTableView>("portTable")->selectRow(0); });
    QVERIFY((choices.back() == SerialPortChoice{"", trekUsbId, ""}));
    choose([this] {
        auto* path = find<QLineEdit>("portPathEdit");
        path->clear();
        QTest::keyClicks(path, QStringLiteral("/dev/serial/kit"));
    });
    QVERIFY((choices.back() == SerialPortChoice{"/dev/serial/kit", {}, ""}));
}

void SerialPortDialogTest::theDialectIsFoundOrChosen()
{
    openRunning();
    std::optional<UwbDialect> chosen;
    connect(m_window.get(), &MainWindow::uwbPortChosen, this,
            [&chosen](const SerialPortChoice&, std::optional<UwbDialect> dialect) { chosen = dialect; });
    trigger("uwbPortAction");
    auto* dialects = find<QComboBox>("dialectCombo");
    QCOMPARE(dialects->count(), static_cast<int>(uwbDialectCount));
    QCOMPARE(dialects->currentIndex(), 0);
    dialects->setCurrentIndex(dialects->findData(static_cast<int>(UwbDialect::UlmEight)));
    click("usePortButton");
    QCOMPARE(chosen, std::optional(UwbDialect::UlmEight));
    QCOMPARE(m_edited.back().second.dialect, std::optional(UwbDialect::UlmEight));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    trigger("uwbPortAction");
    dialects = find<QComboBox>("dialectCombo");
    QCOMPARE(dialects->currentData().toInt(), static_cast<int>(UwbDialect::UlmEight));
    dialects->setCurrentIndex(0);
    click("usePortButton");
    QVERIFY(!chosen);
}

void SerialPortDialogTest::theUnitIsAskedAndItsAnswerShown()
{
    openRunning();
    trigger("uwbPortAction");
    QVERIFY(find<QLabel>("unitLabel")->text().contains(QStringLiteral("Ver.2.25mx TREK")));
    QSignalSpy asks(m_window.get(), &MainWindow::askUwbRequested);
    click("askUnitButton");
    QCOMPARE(asks.count(), 1);
    PlantSnapshot snapshot = scenes::uwbRunning();
    snapshot.uwb->link.state = LinkState::Down;
    m_window->showSnapshot(snapshot);
    QVERIFY(!find<QPushButton>("askUnitButton")->isEnabled());
    QVERIFY(find<QLabel>("unitLabel")->text().contains(QStringLiteral("not connected")));
}

void SerialPortDialogTest::thePortIsChosenFromTheRowOfTheUnit()
{
    openRunning();
    QVERIFY(!find<QPushButton>("portButton")->isVisible());
    find<HintTableView>("linkTable")->selectRow(8);
    QVERIFY(find<QPushButton>("portButton")->isVisible());
    click("portButton");
    QVERIFY(m_window->findChild<SerialPortDialog*>());
}

QTEST_MAIN(SerialPortDialogTest)
#include "test_serial_port_dialog.moc"
