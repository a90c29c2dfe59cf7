// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "app/simulated_plant.h"

#include <csignal>
#include <cstring>

namespace agv::app {

class SimulatedPlantTest : public QObject {
    Q_OBJECT
private slots:
    void saysHowItEnded_data()
    {
        QTest::addColumn<QByteArray>("end");
        QTest::addColumn<QString>("expected");
        QTest::newRow("status") << QByteArray("3")
                                << "The simulated plant ended unexpectedly (exit status 3)";
        QTest::newRow("signal") << QByteArray("signal")
                                << QStringLiteral("The simulated plant was ended by signal %1").arg(SIGKILL);
    }
    void saysHowItEnded()
    {
        QFETCH(QByteArray, end);
        QFETCH(QString, expected);
        qputenv("AGV_TEST_END", end);
        SimulatedPlant plant({});
        QSignalSpy died(&plant, &SimulatedPlant::died);
        plant.start();
        QTRY_COMPARE(died.size(), 1);
        QCOMPARE(died[0][0].toString(), expected);
    }
};

} // namespace agv::app

/// SimulatedPlant starts this very program with "simulate": then it ends as the test asks.
int main(int argc, char** argv)
{
    if (argc > 1 && std::strcmp(argv[1], "simulate") == 0) {
        const QByteArray end = qgetenv("AGV_TEST_END");
        if (end == "signal")
            ::raise(SIGKILL);
        return end.toInt();
    }
    QCoreApplication application(argc, argv);
    agv::app::SimulatedPlantTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_simulated_plant.moc"
