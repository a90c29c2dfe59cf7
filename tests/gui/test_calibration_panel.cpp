// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "gui/event_panel.h"
#include "gui/hint_table_view.h"
#include "gui/map/map_widget.h"
#include "gui/window_fixture.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QSpinBox>

using namespace agv;
using namespace agv::gui;

Q_DECLARE_METATYPE(agv::TurnParameters)

/// The calibration of an AGV in the real window.
class CalibrationPanelTest : public WindowFixture {
    Q_OBJECT
private slots:
    void initializationSendsWhatTheFieldsSay();
    void initializationIsOffUntilBothLinksAreUp();
    void initializationIsOffWhileTheAgvTurns();
    void abortIsForTheRunningTurnOnly();
    void theSuggestedSleeptimeIsApplied();
    void anEditedSleeptimeIsSentAndNotOverwritten();
    void aNewSleeptimeFromTheSessionIsShown();
    void theFieldsBeginWithThePlantFilesValues();
    void theFieldsTakeWhatATurnTakes();
    void anEditedWheelSpeedIsSentWithASleeptimeScaledToIt();
    void aNewWheelSpeedFromTheSessionIsShown();
    void theAppliedSleeptimeSaysWhereItIsKeptAndCanBeTakenBack();
    void aSuggestionHoldsForTheWheelSpeedOfItsTurn();
    void thePreviewIsSaidWithItsUncertaintyWhileTheAgvTurns();
    void theTableIsCopiedAsText();
    void aBadStopIsReadAgain();
    void anAbortedTurnSaysWhy();
    void choosingAnAgvOnTheMapChoosesItInThePanel();
    void whyAReaderDoesNotDeliverIsSaidWhereItIsNeeded();
};

void CalibrationPanelTest::initializationSendsWhatTheFieldsSay()
{
    m_window->showSnapshot(scenes::linksUp());
    QSignalSpy starts(m_window.get(), &MainWindow::startTurnRequested);
    find<QComboBox>("robotCombo")->setCurrentIndex(1);
    find<QSpinBox>("sleeptimeSpin")->setValue(1180);
    find<QComboBox>("kindCombo")->setCurrentIndex(1);
    find<QComboBox>("directionCombo")->setCurrentIndex(1);
    find<QComboBox>("stopsCombo")->setCurrentIndex(2);
    find<QSpinBox>("dwellSpin")->setValue(1500);
    find<QAbstractButton>("adaptiveCheck")->setChecked(false);
    click("initialiseButton");
    QCOMPARE(starts.count(), 1);
    QCOMPARE(starts[0][0].toInt(), 2);
    const auto p = starts[0][1].value<TurnParameters>();
    QCOMPARE(p.turnTime_s, 1.180);
    QVERIFY(p.kind == TurnKind::Measured);
    QVERIFY(p.rotation == Rotation::Clockwise);
    QCOMPARE(p.stopsPerTurn, 16);
    QCOMPARE(p.maxDwell_s, 1.5);
    QVERIFY(!p.adaptiveDwell);
    QCOMPARE(p.wheelSpeed_m_s, 0.1);
}

void CalibrationPanelTest::initializationIsOffUntilBothLinksAreUp()
{
    auto* button = find<QAbstractButton>("initialiseButton");
    QVERIFY(!button->isEnabled());
    PlantSnapshot snapshot = scenes::linksUp();
    snapshot.agvs[0].readerLink.state = LinkState::Down;
    m_window->showSnapshot(snapshot);
    QVERIFY(!button->isEnabled());
    QVERIFY(find<QLabel>("phaseLabel")->text().contains(QStringLiteral("Open RFID")));
    m_window->showSnapshot(scenes::linksUp());
    QVERIFY(button->isEnabled());
    QVERIFY(find<QAction>("initialiseAction")->isEnabled());
}

void CalibrationPanelTest::initializationIsOffWhileTheAgvTurns()
{
    m_window->showSnapshot(scenes::turning());
    QVERIFY(!find<QAbstractButton>("initialiseButton")->isEnabled());
    QVERIFY(!find<QSpinBox>("sleeptimeSpin")->isEnabled());
    QVERIFY(find<QLabel>("phaseLabel")->text().startsWith(QStringLiteral("Stop 4 of 9, reading tags.")));
}

void CalibrationPanelTest::abortIsForTheRunningTurnOnly()
{
    QSignalSpy aborts(m_window.get(), &MainWindow::abortTurnRequested);
    m_window->showSnapshot(scenes::linksUp());
    QVERIFY(!find<QAbstractButton>("abortButton")->isEnabled());
    m_window->showSnapshot(scenes::turning());
    click("abortButton");
    QCOMPARE(aborts.count(), 1);
    QCOMPARE(aborts[0][0].toInt(), 1);
}

void CalibrationPanelTest::theSuggestedSleeptimeIsApplied()
{
    m_window->showSnapshot(scenes::finished());
    QSignalSpy changes(m_window.get(), &MainWindow::turnTimeChanged);
    click("applyButton");
    QCOMPARE(changes.count(), 1);
    QCOMPARE(changes[0][0].toInt(), 1);
    QCOMPARE(changes[0][1].toDouble(), 1.175);
    PlantSnapshot applied = scenes::finished();
    applied.agvs[0].turnTime_s = 1.175;
    m_window->showSnapshot(applied);
    QVERIFY(find<QWidget>("applyButton")->isHidden());
    QCOMPARE(find<QSpinBox>("sleeptimeSpin")->value(), 1175);
}

void CalibrationPanelTest::anEditedSleeptimeIsSentAndNotOverwritten()
{
    m_window->showSnapshot(scenes::linksUp());
    QSignalSpy changes(m_window.get(), &MainWindow::turnTimeChanged);
    auto* field = find<QSpinBox>("sleeptimeSpin");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("1200"));
    m_window->showSnapshot(scenes::linksUp());
    QCOMPARE(field->value(), 1200);
    QCOMPARE(changes.count(), 0);
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(changes.count(), 1);
    QCOMPARE(changes[0][1].toDouble(), 1.2);
}

void CalibrationPanelTest::aNewSleeptimeFromTheSessionIsShown()
{
    m_window->showSnapshot(scenes::linksUp());
    PlantSnapshot snapshot = scenes::linksUp();
    snapshot.agvs[0].turnTime_s = 1.3;
    snapshot.agvs[1].turnTime_s = 1.25;
    m_window->showSnapshot(snapshot);
    QCOMPARE(find<QSpinBox>("sleeptimeSpin")->value(), 1300);
    find<QComboBox>("robotCombo")->setCurrentIndex(1);
    QCOMPARE(find<QSpinBox>("sleeptimeSpin")->value(), 1250);
}

void CalibrationPanelTest::theFieldsBeginWithThePlantFilesValues()
{
    PlantLayout plant = scenes::wholePlant();
    plant.agvs[0].turnTime_s = 1.4;
    plant.agvs[0].turnSpeed_m_s = 0.08;
    m_window = std::make_unique<MainWindow>(plant);
    QCOMPARE(find<QSpinBox>("sleeptimeSpin")->value(), 1400);
    QCOMPARE(find<QSpinBox>("wheelSpeedSpin")->value(), 80);
    QCOMPARE(find<QSpinBox>("dwellSpin")->value(), 2000);
}

void CalibrationPanelTest::theFieldsTakeWhatATurnTakes()
{
    const auto* sleeptime = find<QSpinBox>("sleeptimeSpin");
    QCOMPARE(sleeptime->minimum(), leastSleeptime_ms);
    QCOMPARE(sleeptime->maximum(), mostSleeptime_ms);
    const auto* speed = find<QSpinBox>("wheelSpeedSpin");
    QCOMPARE(speed->minimum() * 1e-3, leastTurnSpeed);
    QCOMPARE(speed->maximum() * 1e-3, mostTurnSpeed);
    QCOMPARE(find<QSpinBox>("dwellSpin")->maximum() * 1e-3, mostDwell_s);
}

void CalibrationPanelTest::anEditedWheelSpeedIsSentWithASleeptimeScaledToIt()
{
    m_window->showSnapshot(scenes::linksUp());
    QSignalSpy speeds(m_window.get(), &MainWindow::turnSpeedChanged);
    QSignalSpy times(m_window.get(), &MainWindow::turnTimeChanged);
    QSignalSpy starts(m_window.get(), &MainWindow::startTurnRequested);
    auto* field = find<QSpinBox>("wheelSpeedSpin");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("50"));
    QTest::keyClick(field, Qt::Key_Return);
    m_window->showSnapshot(scenes::linksUp()); // the session has not answered yet
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(speeds.count(), 1);
    QCOMPARE(speeds[0][0].toInt(), 1);
    QCOMPARE(speeds[0][1].toDouble(), 0.05);
    QVERIFY(times.count() >= 1);
    QCOMPARE(times[0][1].toDouble(), 2.25);
    QCOMPARE(find<QSpinBox>("sleeptimeSpin")->value(), 2250);
    click("initialiseButton");
    QCOMPARE(starts.count(), 1);
    const auto p = starts[0][1].value<TurnParameters>();
    QCOMPARE(p.wheelSpeed_m_s, 0.05);
    QCOMPARE(p.turnTime_s, 2.25);
}

void CalibrationPanelTest::aNewWheelSpeedFromTheSessionIsShown()
{
    PlantSnapshot snapshot = scenes::linksUp();
    snapshot.agvs[0].turnSpeed_m_s = 0.12;
    snapshot.agvs[1].turnSpeed_m_s = 0.06;
    m_window->showSnapshot(snapshot);
    QCOMPARE(find<QSpinBox>("wheelSpeedSpin")->value(), 120);
    find<QComboBox>("robotCombo")->setCurrentIndex(1);
    QCOMPARE(find<QSpinBox>("wheelSpeedSpin")->value(), 60);
    QCOMPARE(find<QSpinBox>("sleeptimeSpin")->value(), 1125);
}

void CalibrationPanelTest::theAppliedSleeptimeSaysWhereItIsKeptAndCanBeTakenBack()
{
    PlantSnapshot snapshot = scenes::finished();
    m_window->showSnapshot(snapshot);
    QSignalSpy kept(m_window.get(), &MainWindow::turnTimeApplied);
    QSignalSpy changes(m_window.get(), &MainWindow::turnTimeChanged);
    QVERIFY(find<QWidget>("undoButton")->isHidden());
    click("applyButton");
    QCOMPARE(kept.count(), 1);
    QCOMPARE(kept[0][0].toInt(), 1);
    QCOMPARE(kept[0][1].toDouble(), 1.175);
    QCOMPARE(kept[0][2].toDouble(), 0.1);
    m_window->showTurnTimeKept(
        1, EventLevel::Info,
        QStringLiteral("Sleeptime 1175 ms is written to plant.json; there it was 1125 ms"));
    snapshot.agvs[0].turnTime_s = 1.175;
    m_window->showSnapshot(snapshot);
    QCOMPARE(find<QLabel>("appliedLabel")->text(),
             QStringLiteral("Sleeptime 1175 ms is written to plant.json; there it was 1125 ms"));
    QVERIFY(find<EventPanel>("events")->selectedText().contains(QStringLiteral("is written to plant.json")));
    click("undoButton");
    QCOMPARE(kept.count(), 2);
    QCOMPARE(kept[1][1].toDouble(), 1.125);
    QCOMPARE(changes.last()[1].toDouble(), 1.125);
    snapshot.agvs[0].turnTime_s = 1.125;
    m_window->showSnapshot(snapshot);
    QVERIFY(find<QWidget>("undoButton")->isHidden());
    QVERIFY(find<QWidget>("appliedLabel")->isHidden());
    QVERIFY(find<QWidget>("applyButton")->isVisible());
}

void CalibrationPanelTest::aSuggestionHoldsForTheWheelSpeedOfItsTurn()
{
    PlantSnapshot snapshot = scenes::finished();
    snapshot.agvs[0].turnSpeed_m_s = 0.05;
    snapshot.agvs[0].turnTime_s = 2.25;
    m_window->showSnapshot(snapshot);
    QVERIFY(find<QWidget>("applyButton")->isHidden());
    QVERIFY(find<QWidget>("suggestionLabel")->isHidden());
    snapshot.agvs[0].turnSpeed_m_s = snapshot.agvs[0].turn.wheelSpeed_m_s;
    m_window->showSnapshot(snapshot);
    QVERIFY(find<QWidget>("applyButton")->isVisible());
}

void CalibrationPanelTest::thePreviewIsSaidWithItsUncertaintyWhileTheAgvTurns()
{
    const auto* line = find<QLabel>("previewLabel");
    QVERIFY(line->isHidden());
    PlantSnapshot snapshot = scenes::turning();
    m_window->showSnapshot(snapshot);
    QVERIFY(line->isVisible());
    QString text = line->text();
    text.replace(QChar(QChar::Nbsp), QLatin1Char(' '));
    QCOMPARE(text, QStringLiteral("So far: x 1,204 mm, y 873 mm, facing −123.2° (95 %: ±19 mm, ±7.9°)"));
    auto ambiguous = std::make_shared<TurnEstimate>(*snapshot.agvs[0].turn.preview);
    ambiguous->flags = {TurnFlag::Ambiguous};
    snapshot.agvs[0].turn.preview = ambiguous;
    m_window->showSnapshot(snapshot);
    QVERIFY(line->text().endsWith(QStringLiteral("a second position is still possible")));
    m_window->showSnapshot(scenes::finished());
    QVERIFY(line->isHidden());
}

void CalibrationPanelTest::theTableIsCopiedAsText()
{
    m_window->showSnapshot(scenes::finished());
    click("copyButton");
    const QStringList lines =
        QGuiApplication::clipboard()->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 10);
    QVERIFY(lines[0].startsWith(QStringLiteral("Stop\tReads\tTag 1\t")));
    QVERIFY(lines[1].contains(QStringLiteral("E00401503B")));
}

void CalibrationPanelTest::aBadStopIsReadAgain()
{
    m_window->showSnapshot(scenes::ambiguous());
    QSignalSpy retakes(m_window.get(), &MainWindow::retakeStopRequested);
    QVERIFY(!find<QAbstractButton>("retakeButton")->isEnabled());
    find<HintTableView>("stopTable")->selectRow(4);
    click("retakeButton");
    QCOMPARE(retakes.count(), 1);
    QCOMPARE(retakes[0][0].toInt(), 1);
    QCOMPARE(retakes[0][1].toInt(), 4);
}

void CalibrationPanelTest::anAbortedTurnSaysWhy()
{
    m_window->showSnapshot(scenes::linkLost());
    QVERIFY(find<QWidget>("resultCard")->isVisible());
    QCOMPARE(find<QLabel>("verdictLabel")->text(), QStringLiteral("Turn aborted"));
    QVERIFY(find<QLabel>("resultLabel")->text().contains(QStringLiteral("lost at stop 5")));
}

void CalibrationPanelTest::choosingAnAgvOnTheMapChoosesItInThePanel()
{
    const PlantSnapshot snapshot = scenes::finished();
    m_window->showSnapshot(snapshot);
    auto* map = find<MapWidget>("map");
    QTest::mouseClick(map, Qt::LeftButton, {},
                      map->viewport().toPixels(snapshot.agvs[2].pose->position).toPoint());
    QCOMPARE(find<QComboBox>("robotCombo")->currentText(), QStringLiteral("AGV 3"));
}

void CalibrationPanelTest::whyAReaderDoesNotDeliverIsSaidWhereItIsNeeded()
{
    find<QComboBox>("robotCombo")->setCurrentIndex(3);
    m_window->showSnapshot(scenes::linkLost());
    QVERIFY(find<QLabel>("phaseLabel")->text().contains(QStringLiteral("The address is not known")));
}

QTEST_MAIN(CalibrationPanelTest)
#include "test_calibration_panel.moc"
