// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "gui/anchor_survey_dialog.h"
#include "gui/correction_dialog.h"
#include "gui/range_calibration_dialog.h"
#include "gui/serial_port_dialog.h"
#include "gui/uwb_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

using namespace agv;
using namespace agv::gui;

/// Correction table, calibration of ranges, placing of anchors.
class UwbDialogTest : public UwbFixture {
    Q_OBJECT
private slots:
    void correctionsAreEditedAndUndoneInTheDialog();
    void aRefusedCorrectionLeavesASentence();
    void theEmptyCorrectionTableSaysWhy();
    void aCalibrationIsCollectedAndAcceptedAsOneEdit();
    void aCalibrationCanBeDiscarded();
    void aFailedCalibrationSaysWhyAndCanBeStartedAgain();
    void aCalibrationIsCancelledByButtonAndByClosing();
    void theResultOfAnEarlierCalibrationIsNotTakenForThisOne();
    void aCalibrationNeedsAConnectedUnit();
    void theKnownPointComesFromAnAgvOrAFloorTag();
    void aSurveyIsShownAndAcceptedAsOneEdit();
    void aSurveyCanBeFlippedTurnedAndLaidOnAnAnchor();
    void aSurveyWithoutPlacesSaysWhy();
    void theNotesOfASurveyAreShown();
    void everyButtonOfADialogHasAToolTip();

private:
    void showState(RangeCalibrationState state, double progress) const
    {
        m_window->showSnapshot(scenes::uwbCalibrating(state, progress));
    }
    QString status() const { return find<QLabel>("rangeStatusLabel")->text(); }
};

void UwbDialogTest::correctionsAreEditedAndUndoneInTheDialog()
{
    openRunning();
    const PlantLayout plant = scenes::uwbPlant();
    trigger("correctionsAction");
    QCOMPARE(cell("correctionTable", 1, 0), QChar(0x2212) + QStringLiteral("5.2"));
    QCOMPARE(find<HintTableView>("correctionTable")->model()->columnCount(),
             2); // T0, and tag 5 that is heard
    QVERIFY(enter("correctionTable", 0, 1, QStringLiteral("3.5")));
    QVERIFY((m_edited.back().second.corrections.back() == RangeCorrection{0, 5, 0.035}));
    QVERIFY(undoes(plant.anchors, plant.uwb));
    QCOMPARE(cell("correctionTable", 0, 1), QStringLiteral("–"));
}

void UwbDialogTest::aRefusedCorrectionLeavesASentence()
{
    openRunning();
    trigger("correctionsAction");
    QVERIFY(!enter("correctionTable", 0, 0, QStringLiteral("x")));
    QVERIFY(m_edited.empty());
    bool said = false;
    for (const QLabel* label : m_window->findChild<CorrectionDialog*>()->findChildren<QLabel*>())
        said = said || label->text().contains(QStringLiteral("\"x\" is not a number"));
    QVERIFY(said);
}

void UwbDialogTest::theEmptyCorrectionTableSaysWhy()
{
    trigger("correctionsAction");
    const auto* table = find<HintTableView>("correctionTable");
    QVERIFY(table->showsHint() && table->hint().contains(QStringLiteral("no anchors")));
}

void UwbDialogTest::aCalibrationIsCollectedAndAcceptedAsOneEdit()
{
    openRunning();
    const PlantLayout plant = scenes::uwbPlant();
    trigger("calibrateRangesAction");
    QSignalSpy starts(m_window.get(), &MainWindow::startRangeCalibrationRequested);
    find<QDoubleSpinBox>("pointXSpin")->setValue(1500);
    find<QDoubleSpinBox>("pointYSpin")->setValue(-200);
    find<QSpinBox>("secondsSpin")->setValue(20);
    QVERIFY(!find<QPushButton>("acceptCorrectionsButton")->isEnabled());
    click("collectButton");
    QCOMPARE(starts.count(), 1);
    QCOMPARE(starts[0], (QList<QVariant>{0, 1.5, -0.2, 0.3, 20.0})); // z is the tag's height
    QVERIFY(!find<QComboBox>("calibratedTagCombo")->isEnabled());
    showState(RangeCalibrationState::Collecting, 0.5);
    QCOMPARE(find<QProgressBar>("collectProgress")->value(), 500);
    QCOMPARE(cell("rangeCalibrationTable", 0, 1), QStringLiteral("150"));
    QVERIFY(!find<QPushButton>("acceptCorrectionsButton")->isEnabled());
    showState(RangeCalibrationState::Finished, 1.0);
    QVERIFY(status().startsWith(QStringLiteral("Finished")));
    click("acceptCorrectionsButton");
    QCOMPARE(m_edited.size(), std::size_t{1});
    QVERIFY((m_edited[0].second.corrections ==
             std::vector<RangeCorrection>{{1, 0, -0.048}, {0, 0, -0.031}, {2, 0, -0.027}}));
    QVERIFY(undoes(plant.anchors, plant.uwb));
}

void UwbDialogTest::aCalibrationCanBeDiscarded()
{
    openRunning();
    trigger("calibrateRangesAction");
    click("collectButton");
    showState(RangeCalibrationState::Collecting, 0.5);
    showState(RangeCalibrationState::Finished, 1.0);
    QSignalSpy cancels(m_window.get(), &MainWindow::cancelRangeCalibrationRequested);
    QCOMPARE(find<QPushButton>("discardCorrectionsButton")->text(), QStringLiteral("&Discard"));
    click("discardCorrectionsButton");
    QVERIFY(m_edited.empty());
    QCOMPARE(cancels.count(), 0);
    QTRY_VERIFY(!m_window->findChild<RangeCalibrationDialog*>());
}

void UwbDialogTest::aFailedCalibrationSaysWhyAndCanBeStartedAgain()
{
    openRunning();
    trigger("calibrateRangesAction");
    QSignalSpy starts(m_window.get(), &MainWindow::startRangeCalibrationRequested);
    click("collectButton");
    showState(RangeCalibrationState::Failed, 0.0);
    QCOMPARE(status(), QStringLiteral("No corrections: The tag was not heard: switch it on"));
    QVERIFY(!find<QPushButton>("acceptCorrectionsButton")->isEnabled());
    QCOMPARE(find<QPushButton>("collectButton")->text(), QStringLiteral("&Start again"));
    click("collectButton");
    QCOMPARE(starts.count(), 2);
    // It fails the same way again: the snapshots look as they did before, and the dialog must not wait for
    // ever.
    for (int i = 0; i < 40; ++i)
        showState(RangeCalibrationState::Failed, 0.0);
    QVERIFY(status().startsWith(QStringLiteral("No corrections")));
}

void UwbDialogTest::aCalibrationIsCancelledByButtonAndByClosing()
{
    openRunning();
    trigger("calibrateRangesAction");
    QSignalSpy cancels(m_window.get(), &MainWindow::cancelRangeCalibrationRequested);
    click("collectButton");
    showState(RangeCalibrationState::Collecting, 0.2);
    QCOMPARE(find<QPushButton>("collectButton")->text(), QStringLiteral("&Cancel"));
    click("collectButton");
    QCOMPARE(cancels.count(), 1);
    QVERIFY(find<QComboBox>("calibratedTagCombo")->isEnabled());
    click("collectButton");
    m_window->findChild<RangeCalibrationDialog*>()->close();
    QCOMPARE(cancels.count(), 2);
    QVERIFY(m_edited.empty());
}

void UwbDialogTest::theResultOfAnEarlierCalibrationIsNotTakenForThisOne()
{
    openRunning();
    showState(RangeCalibrationState::Finished, 1.0);
    trigger("calibrateRangesAction");
    QVERIFY(!find<QPushButton>("acceptCorrectionsButton")->isEnabled());
    click("collectButton");
    showState(RangeCalibrationState::Finished, 1.0); // still on its way
    QVERIFY(!find<QPushButton>("acceptCorrectionsButton")->isEnabled());
    showState(RangeCalibrationState::Collecting, 0.1);
    showState(RangeCalibrationState::Finished, 1.0);
    QVERIFY(find<QPushButton>("acceptCorrectionsButton")->isEnabled());
}

void UwbDialogTest::aCalibrationNeedsAConnectedUnit()
{
    openRunning();
    PlantSnapshot snapshot = scenes::uwbRunning();
    snapshot.uwb->link.state = LinkState::Down;
    m_window->showSnapshot(snapshot);
    trigger("calibrateRangesAction");
    QVERIFY(!find<QPushButton>("collectButton")->isEnabled());
    QVERIFY2(status().contains(QStringLiteral("not connected")), qPrintable(status()));
    m_window->showSnapshot(scenes::uwbRunning());
    QVERIFY(find<QPushButton>("collectButton")->isEnabled());
}

void UwbDialogTest::theKnownPointComesFromAnAgvOrAFloorTag()
{
    openRunning();
    trigger("calibrateRangesAction");
    auto* menu = find<QPushButton>("useAgvButton")->menu();
    emit menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 3); // the located ones
    menu->actions().at(1)->trigger();    // AGV 2 does not carry the tag: its centre
    QCOMPARE(find<QDoubleSpinBox>("pointXSpin")->value(), 2210.0);
    emit menu->aboutToShow();
    menu->actions().at(0)->trigger(); // AGV 1 carries it 50 mm before its centre, and faces 92.3 degrees
    QCOMPARE(find<QDoubleSpinBox>("pointXSpin")->value(), 1202.0);
    QCOMPARE(find<QDoubleSpinBox>("pointYSpin")->value(), 923.0);
    auto* field = find<QLineEdit>("floorTagEdit");
    field->setText(QStringLiteral("43")); // first column is 1 to 41
    click("useFloorTagButton");
    QCOMPARE(find<QDoubleSpinBox>("pointXSpin")->value(), 100.0);
    QCOMPARE(find<QDoubleSpinBox>("pointYSpin")->value(), 100.0);
    field->setText(QStringLiteral("99999"));
    click("useFloorTagButton");
    QCOMPARE(status(), QStringLiteral("There is no floor tag \"99999\"."));
    QCOMPARE(find<QDoubleSpinBox>("pointXSpin")->value(), 100.0);
}

void UwbDialogTest::aSurveyIsShownAndAcceptedAsOneEdit()
{
    openRunning();
    const PlantLayout plant = scenes::uwbPlant();
    QSignalSpy requests(m_window.get(), &MainWindow::surveyAnchorsRequested);
    trigger("placeAnchorsAction");
    QCOMPARE(requests.count(), 1);
    QVERIFY(!find<QPushButton>("moveAnchorsButton")->isEnabled());
    m_window->showAnchorSurvey(scenes::uwbSurvey());
    QVERIFY(find<QPushButton>("moveAnchorsButton")->isEnabled());
    QVERIFY(
        find<QLabel>("surveyStatusLabel")->text().startsWith(QStringLiteral("Ranges minus distances: 21")));
    const std::vector<UwbAnchor> proposed = m_window->findChild<AnchorSurveyDialog*>()->proposal();
    click("moveAnchorsButton");
    QCOMPARE(m_edited.size(), std::size_t{1});
    QVERIFY(m_edited[0].first == proposed);
    QVERIFY(std::abs(distance({proposed[1].x, proposed[1].y}, {proposed[2].x, proposed[2].y}) - 3.98) < 1e-9);
    QVERIFY(undoes(plant.anchors, plant.uwb));
}

void UwbDialogTest::aSurveyCanBeFlippedTurnedAndLaidOnAnAnchor()
{
    openRunning();
    trigger("placeAnchorsAction");
    m_window->showAnchorSurvey(scenes::uwbSurvey());
    const auto* dialog = m_window->findChild<AnchorSurveyDialog*>();
    auto* frame = find<QComboBox>("surveyFrameCombo");
    QCOMPARE(frame->count(), 5);
    frame->setCurrentIndex(frame->findText(QStringLiteral("with A0 at the origin")));
    const auto at = [dialog](std::size_t i) {
        return Point2{dialog->proposal()[i].x, dialog->proposal()[i].y};
    };
    QVERIFY(distance(at(0), {0.0, 0.0}) < 1e-9 && distance(at(1), {3.3, 0.0}) < 1e-9);
    find<QCheckBox>("surveyFlipCheck")->setChecked(true);
    QVERIFY(distance(at(1), {-3.3, 0.0}) < 1e-9 && distance(at(3), {0.0, 4.3}) < 1e-9);
    find<QDoubleSpinBox>("surveyRotationSpin")->setValue(90.0);
    QVERIFY(distance(at(1), {0.0, -3.3}) < 1e-9 && distance(at(3), {-4.3, 0.0}) < 1e-9);
}

void UwbDialogTest::aSurveyWithoutPlacesSaysWhy()
{
    openRunning();
    trigger("placeAnchorsAction");
    AnchorSurvey survey;
    survey.trouble = "Only 2 anchors range each other: three are needed";
    m_window->showAnchorSurvey(survey);
    QCOMPARE(find<QLabel>("surveyStatusLabel")->text(), QString::fromStdString(survey.trouble));
    QVERIFY(!find<QPushButton>("moveAnchorsButton")->isEnabled());
    QVERIFY(!find<QComboBox>("surveyFrameCombo")->isEnabled());
    QSignalSpy requests(m_window.get(), &MainWindow::surveyAnchorsRequested);
    click("surveyAgainButton");
    QCOMPARE(requests.count(), 1);
}

void UwbDialogTest::theNotesOfASurveyAreShown()
{
    openRunning();
    trigger("placeAnchorsAction");
    AnchorSurvey survey = scenes::uwbSurvey();
    survey.anchors.pop_back();
    survey.notes = {"Anchor 3 was not placed: it ranges no other anchor"};
    m_window->showAnchorSurvey(survey);
    QVERIFY(find<QLabel>("surveyStatusLabel")->text().contains(QStringLiteral("Anchor 3 was not placed")));
    click("moveAnchorsButton");
    QVERIFY(m_edited.back().first[3] == scenes::uwbPlant().anchors[3]);
}

void UwbDialogTest::everyButtonOfADialogHasAToolTip()
{
    openRunning();
    for (const char* action : {"calibrateRangesAction", "placeAnchorsAction", "uwbPortAction"})
        trigger(action);
    for (QWidget* dialog : std::initializer_list<QWidget*>{m_window->findChild<RangeCalibrationDialog*>(),
                                                           m_window->findChild<AnchorSurveyDialog*>(),
                                                           m_window->findChild<SerialPortDialog*>()}) {
        QVERIFY(dialog && !dialog->isModal()); // Stop all stays in reach
        for (const QPushButton* button : dialog->findChildren<QPushButton*>())
            QVERIFY2(!button->text().isEmpty() && !button->toolTip().isEmpty(), qPrintable(button->text()));
    }
}

QTEST_MAIN(UwbDialogTest)
#include "test_uwb_dialogs.moc"
