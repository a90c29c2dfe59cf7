// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "link/pseudo_terminal.h"
#include "link/serial_link.h"

#include <memory>
#include <ranges>

namespace agv::link {
namespace {

SerialPortEntry trekPort(const QString& path, const QString& serialNumber)
{
    return {path, QStringLiteral("STM32 Virtual COM Port"), trekUsbId, serialNumber};
}

SerialPortChoice byPath(const QString& path) { return {path.toStdString(), {}, {}}; }

} // namespace

class SerialLinkTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        m_ports.clear();
        m_received.clear();
        m_unit = std::make_unique<PseudoTerminal>();
        QVERIFY(m_unit->isGood());
        m_link = std::make_unique<SerialLink>([this] { return m_ports; });
        connect(m_link.get(), &SerialLink::received, this,
                [this](const Chunk& chunk) { m_received.push_back(chunk); });
    }
    void cleanup()
    {
        m_link.reset();
        m_unit.reset();
    }

    void deliversAllByteValuesBothWaysWithTheTimeOfTheirArrival()
    {
        openByPath();
        QByteArray all;
        for (int i = 0; i < 256; ++i)
            all += static_cast<char>(i);
        const Time before = std::chrono::steady_clock::now();
        QVERIFY(m_unit->write(all));
        QTRY_COMPARE(allBytes(), all);
        QVERIFY(m_received.front().time >= before);
        QVERIFY(m_received.back().time <= std::chrono::steady_clock::now());
        QVERIFY(m_link->write(all));
        QByteArray arrived;
        QTRY_COMPARE(arrived += m_unit->read(), all);
    }
    void reportsOneFailureAndIsClosedWhenTheUnitIsUnplugged()
    {
        openByPath();
        QSignalSpy failed(m_link.get(), &SerialLink::failed);
        const QString path = m_unit->path();
        m_unit.reset();
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toBool());
        QVERIFY(failed[0][1].toString().contains(path + " is gone: the unit was unplugged"));
        QVERIFY(!m_link->isConnected());
        QVERIFY(!failed.wait(50));
    }
    void reportsAPortThatIsNotThereAsTransient()
    {
        QCOMPARE(failureOf(byPath("/dev/no-such-port")),
                 "There is no serial port /dev/no-such-port: plug the unit in, or choose another port");
        QVERIFY(m_transient);
    }
    void namesTheUsbIdAndTheSerialNumberOfAUnitThatIsNotPluggedIn()
    {
        QVERIFY(failureOf({}).contains("serial port USB 0483:5740:"));
        QVERIFY(failureOf({"", UsbId{0x1a86, 0x7523}, "77"})
                    .contains("serial port USB 1a86:7523, serial number 77:"));
    }
    void reportsAPortThatAnotherProgramHoldsAsTransient()
    {
        QSerialPort other(m_unit->path());
        QVERIFY(other.open(QIODevice::ReadWrite));
        const QString reason = failureOf(byPath(m_unit->path()));
        QVERIFY2(reason.contains(m_unit->path() + " is in use"), qPrintable(reason));
        QVERIFY(m_transient);
        other.close();
        openByPath();
    }
    void reportsAFileThatIsNoSerialPortAsPersistent()
    {
        QVERIFY(failureOf(byPath("/etc/passwd")).contains("/etc/passwd is no serial port"));
        QVERIFY(!m_transient);
    }
    void failsAfterOpenHasReturned()
    {
        QSignalSpy failed(m_link.get(), &SerialLink::failed);
        m_link->open(byPath("/dev/no-such-port"));
        QCOMPARE(failed.size(), 0);
        QTRY_COMPARE(failed.size(), 1);
    }
    void canBeOpenedAgainFromInsideItsOwnFailure()
    {
        openByPath();
        const PseudoTerminal second;
        QSignalSpy connected(m_link.get(), &SerialLink::connected);
        connect(m_link.get(), &SerialLink::failed, this, [&] { m_link->open(byPath(second.path())); });
        m_unit.reset();
        QTRY_COMPARE(connected.size(), 1);
        QVERIFY(m_link->isConnected());
        QCOMPARE(m_link->port()->path, second.path());
    }
    void closingIsSilentAndFreesThePort()
    {
        openByPath();
        QSignalSpy failed(m_link.get(), &SerialLink::failed);
        m_link->close();
        m_link->close();
        QVERIFY(!m_link->isConnected());
        QSerialPort other(m_unit->path());
        QVERIFY(other.open(QIODevice::ReadWrite));
        QCOMPARE(failed.size(), 0);
    }
    void closingBeforeThePortIsOpenCallsTheAttemptOff()
    {
        QSignalSpy connected(m_link.get(), &SerialLink::connected);
        m_link->open(byPath(m_unit->path()));
        m_link->close();
        QVERIFY(!connected.wait(50));
    }
    void doesNotDeliverWhatCameBeforeItWasOpened()
    {
        openByPath();
        m_link->close();
        QVERIFY(m_unit->write("stale"));
        openByPath();
        QVERIFY(m_unit->write("fresh"));
        QTRY_COMPARE(allBytes(), QByteArray("fresh"));
    }
    void refusesToSendMoreThanItsBacklogToAUnitThatDoesNotRead()
    {
        openByPath();
        const QByteArray block(1024, 'x');
        int taken = 0;
        for (; taken < 100 && m_link->write(block); ++taken)
            QCoreApplication::processEvents();
        QVERIFY(taken < 100);
        m_link->close();
        QVERIFY(!m_link->write("x"));
    }
    void prefersTheTrekPortWhenNothingIsChosen()
    {
        m_ports = {{"/dev/ttyS0", "", {}, ""}, trekPort(m_unit->path(), "1")};
        open({});
        QCOMPARE(*m_link->port(), m_ports[1]);
    }
    void findsAnUnpluggedUnitAtItsNewPlaceByItsSerialNumber()
    {
        const PseudoTerminal other;
        m_ports = {trekPort(m_unit->path(), "A"), trekPort(other.path(), "B")};
        const SerialPortChoice choice = byPath(m_unit->path());
        open(choice);
        QSignalSpy failed(m_link.get(), &SerialLink::failed);
        m_unit.reset();
        QTRY_COMPARE(failed.size(), 1);

        const PseudoTerminal elsewhere;
        m_ports = {trekPort(other.path(), "B"), trekPort(elsewhere.path(), "A")};
        open(choice);
        QCOMPARE(m_link->port()->path, elsewhere.path());
        QCOMPARE(m_link->port()->serialNumber, "A");
    }
    void forgetsTheUnitWhenAnotherPortIsChosen()
    {
        const PseudoTerminal other;
        m_ports = {trekPort(m_unit->path(), "A"), trekPort(other.path(), "B")};
        open({"", trekUsbId, "A"});
        open({"", trekUsbId, "B"});
        QCOMPARE(m_link->port()->path, other.path());
    }
    void aPathMayBeALinkAndItsUsbIdMayBeSaidByTheChoice()
    {
        const QTemporaryDir folder;
        const QString link = folder.filePath("uwb");
        QVERIFY(QFile::link(m_unit->path(), link));
        open({link.toStdString(), trekUsbId, ""});
        QVERIFY(m_link->port()->usb == trekUsbId);
    }

    void listsTrekUnitsFirstThenUsbDevicesThenTheRest()
    {
        std::vector<SerialPortEntry> ports{{"/dev/ttyS10", "", {}, ""},
                                           {"/dev/ttyS9", "", {}, ""},
                                           {"/dev/ttyUSB0", "CH340", UsbId{0x1a86, 0x7523}, ""},
                                           trekPort("/dev/ttyACM1", "2"),
                                           trekPort("/dev/ttyACM0", "1")};
        sortByPreference(ports);
        QStringList order;
        for (const SerialPortEntry& port : ports)
            order << port.path;
        QCOMPARE(order,
                 QStringList({"/dev/ttyACM0", "/dev/ttyACM1", "/dev/ttyUSB0", "/dev/ttyS9", "/dev/ttyS10"}));
        QCOMPARE(toText(ports[0]), "/dev/ttyACM0: STM32 Virtual COM Port (0483:5740, serial number 1)");
        QCOMPARE(toText(ports[2]), "/dev/ttyUSB0: CH340 (1a86:7523)");
        QCOMPARE(toText(ports[3]), "/dev/ttyS9");
    }
    void theListOfTheSystemCanBeAsked()
    {
        for (const SerialPortEntry& port : availableSerialPorts())
            QVERIFY(!port.path.isEmpty());
    }

    void everyFaultHasAMessageOfItsOwnThatSaysWhatToDo()
    {
        QStringList texts;
        for (const SerialFault fault : {SerialFault::Missing, SerialFault::Busy, SerialFault::Forbidden,
                                        SerialFault::NotSerial, SerialFault::Unplugged, SerialFault::Other})
            texts << serialFailureText(fault, "/dev/ttyACM0", "dialout", "Input/output error");
        for (const QString& text : texts) {
            QVERIFY(text.contains("/dev/ttyACM0"));
            QCOMPARE(texts.count(text), 1);
        }
        QVERIFY(texts[2].contains("join the group dialout"));
        QVERIFY(texts[2].contains("udev rule SUBSYSTEM==\"tty\""));
        QVERIFY(texts[5].contains("Input/output error"));
        const QString groupless = serialFailureText(SerialFault::Forbidden, "/dev/ttyACM0", "", "");
        QVERIFY(groupless.contains("udev rule") && !groupless.contains("group"));
    }
    void aHangUpIsAnUnpluggedUnitWhateverTheSystemCallsIt()
    {
        for (const auto error : {QSerialPort::ResourceError, QSerialPort::ReadError, QSerialPort::WriteError})
            QCOMPARE(serialFaultOf(error, true, m_unit->path()), SerialFault::Unplugged);
        QCOMPARE(serialFaultOf(QSerialPort::UnknownError, true, m_unit->path()), SerialFault::Other);
        QCOMPARE(serialFaultOf(QSerialPort::UnknownError, true, "/dev/no-such-port"), SerialFault::Unplugged);
    }
    void tellsAForbiddenPortFromABusyOne()
    {
        if (::geteuid() == 0)
            QSKIP("the superuser may open everything");
        const QTemporaryDir folder;
        QFile file(folder.filePath("port"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.setPermissions({}));
        QCOMPARE(serialFaultOf(QSerialPort::PermissionError, false, file.fileName()), SerialFault::Forbidden);
    }

private:
    void open(const SerialPortChoice& choice)
    {
        QSignalSpy connected(m_link.get(), &SerialLink::connected);
        m_link->open(choice);
        QTRY_COMPARE(connected.size(), 1);
    }
    void openByPath() { open(byPath(m_unit->path())); }
    QString failureOf(const SerialPortChoice& choice)
    {
        QSignalSpy failed(m_link.get(), &SerialLink::failed);
        m_link->open(choice);
        if (failed.isEmpty() && !failed.wait())
            return {};
        m_transient = failed[0][0].toBool();
        return failed[0][1].toString();
    }
    QByteArray allBytes() const
    {
        QByteArray bytes;
        for (const Chunk& chunk : m_received)
            bytes += chunk.bytes;
        return bytes;
    }

    std::vector<SerialPortEntry> m_ports;
    std::vector<Chunk> m_received;
    std::unique_ptr<PseudoTerminal> m_unit;
    std::unique_ptr<SerialLink> m_link;
    bool m_transient = false;
};

} // namespace agv::link

QTEST_GUILESS_MAIN(agv::link::SerialLinkTest)
#include "test_serial_link.moc"
