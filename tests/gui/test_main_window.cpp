// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "gui/event_panel.h"
#include "gui/hint_table_view.h"
#include "gui/plot/stop_fit_plot.h"
#include "gui/window_fixture.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QToolButton>

using namespace agv;
using namespace agv::gui;

/// The frame of the window: links, log, layout, colours, what always stands on the screen.
class MainWindowTest : public WindowFixture {
    Q_OBJECT
private slots:
    void stopAllByClick();
    void stopAllCannotBeHidden();
    void theWindowFitsASmallScreenInGerman();
    void theBannerStandsWheneverThePlantIsSimulated();
    void anAgvThatMayBeMovingLeadsTheLineUnderTheMap();
    void anAgvThatWasMovedIsNamedUnderTheMap();
    void refusedPeersAreShown();
    void emptyTablesSayWhy();
    void theLanguageChangesWhileTheWindowIsOpen();
    void theLayoutSurvivesARestartAndCanBeReset();
    void eventsAreCopiedAsText();
    void detailsAreShownWhenAskedFor();
    void theLogFollowsTheNewestLineUntilTheOperatorScrollsUp();
    void aDarkWindowOnALightDesktopIsReadable();
    void aListenFailureStaysOnTheScreenUntilItIsOver();
    void readShowsTheTagsAndOpensAClosedReader();
    void openAndCloseActOnTheChosenReader();
    void openActsOnAllReadersWhenNoneIsChosen();
    void faultsAreForASimulatedPlantOnly();
};

void MainWindowTest::stopAllByClick()
{
    QSignalSpy stops(m_window.get(), &MainWindow::stopAllRequested);
    auto* button = find<QToolButton>("stopAllButton");
    QVERIFY(button->isVisible());
    QVERIFY(button->toolTip().contains(QStringLiteral("does not replace the emergency stop")));
    click("stopAllButton");
    QCOMPARE(stops.count(), 1);
}

void MainWindowTest::stopAllCannotBeHidden()
{
    const QMenu* menu = m_window->createPopupMenu();
    for (const QAction* action : menu->actions())
        QVERIFY2(!action->isVisible() || action->text() != QStringLiteral("Stop all"),
                 qPrintable(action->text()));
    delete menu;
    for (int width : {700, 1280, 1920}) {
        m_window->resize(width, 800);
        QCoreApplication::processEvents();
        const auto* button = find<QToolButton>("stopAllButton");
        QVERIFY(button->isVisible());
        const QPoint right = button->mapTo(m_window.get(), QPoint(button->width(), 0));
        QVERIFY2(right.x() <= m_window->width(), qPrintable(QString::number(width)));
    }
}

void MainWindowTest::theWindowFitsASmallScreenInGerman()
{
    setUpApplication(*qApp, QLocale(QStringLiteral("de_DE")));
    m_window->showSnapshot(scenes::turning());
    QCoreApplication::processEvents();
    // 1920 x 1080 at a scaling of 200 %.
    m_window->resize(960, 540);
    QCoreApplication::processEvents();
    QVERIFY2(m_window->width() <= 960 && m_window->height() <= 540,
             qPrintable(QStringLiteral("%1 x %2").arg(m_window->width()).arg(m_window->height())));
    QVERIFY(find<QToolButton>("stopAllButton")->visibleRegion().boundingRect() ==
            find<QToolButton>("stopAllButton")->rect());
}

void MainWindowTest::theBannerStandsWheneverThePlantIsSimulated()
{
    const auto* banner = find<QLabel>("simulationBanner");
    m_window->showSnapshot(scenes::linksUp());
    QVERIFY(!banner->isVisible());
    m_window->showSnapshot(scenes::turning());
    QVERIFY(banner->isVisible());
    QVERIFY(banner->text().contains(QStringLiteral("SIMULATION")));
}

void MainWindowTest::anAgvThatMayBeMovingLeadsTheLineUnderTheMap()
{
    const auto* line = find<QLabel>("nextStepLabel");
    m_window->showSnapshot(scenes::linkLost());
    QVERIFY2(line->text().startsWith(QStringLiteral("<b>AGV 1 may still be moving: go and look")),
             qPrintable(line->text()));
    QVERIFY(line->text().endsWith(QStringLiteral("Not located yet: AGV 4. Choose one and press Calibrate.")));
    m_window->showListenFailure(QStringLiteral("Port 2001 is in use"));
    QVERIFY(line->isVisible() && line->text().contains(QStringLiteral("may still be moving")));
    m_window->showListening();
    m_window->showSnapshot(scenes::linksUp());
    QVERIFY(!line->text().contains(QStringLiteral("may still be moving")));
}

void MainWindowTest::anAgvThatWasMovedIsNamedUnderTheMap()
{
    PlantSnapshot snapshot = scenes::finished();
    snapshot.agvs[2].poseHealth = PoseHealth::Doubted;
    m_window->showSnapshot(snapshot);
    QCOMPARE(find<QLabel>("nextStepLabel")->text(),
             QStringLiteral("No longer where it was located: AGV 3. Choose it and press Calibrate."));
}

void MainWindowTest::refusedPeersAreShown()
{
    m_window->showSnapshot(scenes::linksUp());
    const auto* label = find<QLabel>("refusedLabel");
    QVERIFY(!label->isVisible());
    m_window->showSnapshot(scenes::ambiguous());
    QVERIFY(label->isVisible());
    QVERIFY(label->text().contains(QStringLiteral("192.168.1.77:50122")));
}

void MainWindowTest::emptyTablesSayWhy()
{
    for (const char* name : {"linkTable", "vehicleTable", "stopTable", "table"}) {
        const auto* table = find<HintTableView>(name);
        QVERIFY2(table->showsHint() && table->hint().size() > 20, name);
    }
    QVERIFY(!find<StopFitPlot>("fitPlot")->showsData());
    m_window->showSnapshot(scenes::turning());
    QVERIFY(!find<HintTableView>("stopTable")->showsHint());
    QVERIFY(find<StopFitPlot>("fitPlot")->showsData());
}

void MainWindowTest::theLanguageChangesWhileTheWindowIsOpen()
{
    m_window->showSnapshot(scenes::finished());
    QCOMPARE(find<QLabel>("verdictLabel")->text(), QStringLiteral("Position found"));
    setUpApplication(*qApp, QLocale(QStringLiteral("de_DE")));
    QTRY_COMPARE(find<QToolButton>("stopAllButton")->text(), QStringLiteral("Alle anhalten"));
    QCOMPARE(find<QLabel>("verdictLabel")->text(), QStringLiteral("Position gefunden"));
    QCOMPARE(find<QAbstractButton>("initialiseButton")->text(),
             QStringLiteral("&Kalibrieren (Initialisierung)"));
}

void MainWindowTest::theLayoutSurvivesARestartAndCanBeReset()
{
    find<QDockWidget>("eventsDock")->hide();
    m_window->close();
    m_window = std::make_unique<MainWindow>(scenes::wholePlant());
    m_window->show();
    QVERIFY(!find<QDockWidget>("eventsDock")->isVisible());
    find<QAction>("resetLayoutAction")->trigger();
    QTRY_VERIFY(find<QDockWidget>("eventsDock")->isVisible());
}

void MainWindowTest::eventsAreCopiedAsText()
{
    m_window->addEvent({1773761405123, EventLevel::Warning, "AGV 1", "weak battery"});
    QCOMPARE(find<EventPanel>("events")->selectedText(),
             QStringLiteral("2026-03-17T15:30:05.123Z\tWarning\tAGV 1\tweak battery\n"));
}

void MainWindowTest::aDarkWindowOnALightDesktopIsReadable()
{
    m_window->showSnapshot(scenes::linksUp());
    find<QAction>("darkThemeAction")->trigger();
    for (const char* name : {"phaseLabel", "nextStepLabel", "closeButton", "linkTable", "adaptiveCheck"}) {
        auto* widget = find<QWidget>(name);
        widget->ensurePolished();
        QVERIFY2(widget->palette().color(widget->foregroundRole()).lightness() > 120, name);
    }
    find<QAction>("systemThemeAction")->trigger();
    QVERIFY(find<QWidget>("closeButton")->palette().color(QPalette::ButtonText).lightness() < 120);
}

void MainWindowTest::aListenFailureStaysOnTheScreenUntilItIsOver()
{
    m_window->showSnapshot(scenes::linksUp());
    const auto* bar = find<QWidget>("noticeBar");
    QVERIFY(!bar->isVisible());
    m_window->showListenFailure(QStringLiteral("TCP port 2001 on 127.0.0.1 is in use"));
    m_window->showSnapshot(scenes::linksUp());
    QVERIFY(bar->isVisible());
    QVERIFY(find<QLabel>("noticeLabel")->text().contains(QStringLiteral("port 2001")));
    m_window->showListening();
    QVERIFY(!bar->isVisible());
}

void MainWindowTest::readShowsTheTagsAndOpensAClosedReader()
{
    PlantSnapshot snapshot = scenes::turning();
    snapshot.agvs[1].readerLink.state = LinkState::Down;
    m_window->showSnapshot(snapshot);
    QSignalSpy opens(m_window.get(), &MainWindow::openReaderRequested);
    click("readButton");
    QCOMPARE(opens.count(), 1);
    QCOMPARE(opens[0][0].toInt(), 2);
    const auto* label = find<QLabel>("readingLabel");
    QVERIFY(label->isVisible());
    QVERIFY2(label->text().startsWith(QStringLiteral("AGV 1 reads tag (RSSI): ")), qPrintable(label->text()));
    QVERIFY(label->text().contains(QStringLiteral("AGV 2 reads no floor tag")));
    click("readButton");
    QVERIFY(!label->isVisible());
}

void MainWindowTest::openAndCloseActOnTheChosenReader()
{
    m_window->showSnapshot(scenes::idle());
    QSignalSpy opens(m_window.get(), &MainWindow::openReaderRequested);
    QSignalSpy closes(m_window.get(), &MainWindow::closeReaderRequested);
    QVERIFY(!find<QAbstractButton>("closeButton")->isEnabled());
    find<HintTableView>("linkTable")->selectRow(4);
    click("openButton");
    QCOMPARE(opens.count(), 1);
    QCOMPARE(opens[0][0].toInt(), 3);
    m_window->showSnapshot(scenes::linksUp());
    click("closeButton");
    QCOMPARE(closes.count(), 1);
    QCOMPARE(closes[0][0].toInt(), 3);
}

void MainWindowTest::openActsOnAllReadersWhenNoneIsChosen()
{
    m_window->showSnapshot(scenes::idle());
    QSignalSpy opens(m_window.get(), &MainWindow::openReaderRequested);
    click("openButton");
    QCOMPARE(opens.count(), 4);
}

void MainWindowTest::faultsAreForASimulatedPlantOnly()
{
    m_window->showSnapshot(scenes::linksUp());
    const auto* menu = find<QMenu>("simulationMenu");
    QVERIFY(!menu->menuAction()->isVisible());
    m_window->showSnapshot(scenes::turning());
    QVERIFY(menu->menuAction()->isVisible());
    find<QAction>("chooseAgv2Action")->trigger();
    QSignalSpy commands(m_window.get(), &MainWindow::simulationCommandRequested);
    find<QAction>("cutReaderAction")->trigger();
    find<QAction>("restoreAction")->trigger();
    QCOMPARE(commands.count(), 2);
    QCOMPARE(commands[0][0].toString(), QStringLiteral("cut reader 2 10"));
    QCOMPARE(commands[1][0].toString(), QStringLiteral("restore"));
}

void MainWindowTest::detailsAreShownWhenAskedFor()
{
    m_window->addEvent({1, EventLevel::Info, "AGV 1", "Initialisation turn started"});
    m_window->addEvent({2, EventLevel::Detail, "AGV 1", "The robot is driving"});
    const auto* table = find<HintTableView>("table");
    QCOMPARE(table->model()->rowCount(), 1);
    QVERIFY(!find<EventPanel>("events")->selectedText().contains(QStringLiteral("driving")));
    click("detailsButton");
    QCOMPARE(table->model()->rowCount(), 2);
    QVERIFY(find<EventPanel>("events")->selectedText().contains(QStringLiteral("driving")));
}

void MainWindowTest::theLogFollowsTheNewestLineUntilTheOperatorScrollsUp()
{
    const auto addLines = [this](int from, int to) {
        for (int i = from; i < to; ++i)
            m_window->addEvent({i, EventLevel::Info, "AGV 1", std::string(200, 'x') + std::to_string(i)});
        QCoreApplication::processEvents();
    };
    auto* bar = find<HintTableView>("table")->verticalScrollBar();
    addLines(0, 30);
    QVERIFY(bar->maximum() > 0);
    QCOMPARE(bar->value(), bar->maximum());
    m_window->resize(1000, 620); // longer lines, fewer of them in sight
    QCoreApplication::processEvents();
    addLines(30, 31);
    QCOMPARE(bar->value(), bar->maximum());
    bar->setValue(10);
    addLines(31, 40);
    QCOMPARE(bar->value(), 10);
    bar->setValue(bar->maximum());
    addLines(40, 41);
    QCOMPARE(bar->value(), bar->maximum());
}

QTEST_MAIN(MainWindowTest)
#include "test_main_window.moc"
