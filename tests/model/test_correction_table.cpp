// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "model/correction_table_model.h"
#include "model/floor_tag_search.h"
#include "model/range_calibration_model.h"
#include "model/uwb_kit_tables.h"

using namespace agv;
using namespace agv::kit;
using namespace agv::model;

/// Range corrections, as a table and found by a calibration.
class CorrectionTableTest : public QObject {
    Q_OBJECT
private slots:
    void init() { QLocale::setDefault(QLocale(QStringLiteral("en_GB"))); }
    void correctionsAreEditedInCentimetres();
    void anEmptyCellRemovesACorrection();
    void badInputForACorrectionIsRefusedWithASentence();
    void correctionsChangeUnderTheModelTester();
    void aCalibrationReplacesTheCorrectionsOfItsTagAlone();
    void aCalibrationShowsWhatIsThereAndWhatWasFound();
    void floorTagsAreFoundByNumberOrLastDigits();
};

void CorrectionTableTest::correctionsAreEditedInCentimetres()
{
    CorrectionTableModel model;
    model.setSettings(threeAnchors(), oneTag(), {5});
    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(model.columnCount(), 2);
    QCOMPARE(cell(model, 1, 0), QChar(0x2212) + QStringLiteral("5.2"));
    QCOMPARE(cell(model, 0, 0), QStringLiteral("–"));
    QCOMPARE(model.headerData(0, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("Lift (cm)"));
    QSignalSpy edits(&model, &CorrectionTableModel::editRequested);
    QVERIFY(enter(model, 0, 1, QStringLiteral("12.3")));
    const auto corrections = edits[0][1].value<std::vector<RangeCorrection>>();
    QCOMPARE(corrections.size(), std::size_t{2});
    QVERIFY((corrections[1] == RangeCorrection{0, 5, 0.123}));
    QVERIFY(enter(model, 1, 0, QStringLiteral("-6")));
    QVERIFY((edits[1][1].value<std::vector<RangeCorrection>>()[0] == RangeCorrection{1, 3, -0.06}));
}

void CorrectionTableTest::anEmptyCellRemovesACorrection()
{
    CorrectionTableModel model;
    model.setSettings(threeAnchors(), oneTag(), {});
    QSignalSpy edits(&model, &CorrectionTableModel::editRequested);
    QVERIFY(enter(model, 0, 0, QString()));
    QCOMPARE(edits.count(), 0); // there was none
    QVERIFY(enter(model, 1, 0, QStringLiteral(" ")));
    QCOMPARE(edits.count(), 1);
    QVERIFY(edits[0][1].value<std::vector<RangeCorrection>>().empty());
}

void CorrectionTableTest::badInputForACorrectionIsRefusedWithASentence()
{
    CorrectionTableModel model;
    model.setSettings(threeAnchors(), oneTag(), {});
    QSignalSpy edits(&model, &CorrectionTableModel::editRequested);
    QSignalSpy refusals(&model, &CorrectionTableModel::refused);
    QVERIFY(!enter(model, 1, 0, QStringLiteral("much")));
    QVERIFY(!enter(model, 1, 0, QStringLiteral("1000.1")));
    QCOMPARE(edits.count(), 0);
    QCOMPARE(refusals.count(), 2);
    QVERIFY2(refusals[1][0].toString().contains(QStringLiteral("A1 – Lift")),
             qPrintable(refusals[1][0].toString()));
}

void CorrectionTableTest::correctionsChangeUnderTheModelTester()
{
    CorrectionTableModel model;
    const Tester tester(&model, Tester::FailureReportingMode::QtTest);
    model.setSettings(threeAnchors(), {}, {});
    QCOMPARE(model.rowCount(), 0);
    model.setSettings(threeAnchors(), oneTag(), {});
    UwbSettings settings = oneTag();
    settings.corrections.clear();
    model.setSettings(threeAnchors(), settings, {});
    model.setSettings({}, settings, {5});
    QCOMPARE(model.rowCount(), 0);
}

void CorrectionTableTest::aCalibrationReplacesTheCorrectionsOfItsTagAlone()
{
    RangeCalibrationSnapshot calibration;
    calibration.tag = 3;
    calibration.rows = {{0, 300, 0.04, 0.02}, {1, 300, -0.01, 0.02}, {7, 5, {}, 0.0}};
    const std::vector<RangeCorrection> before{{1, 3, -0.052}, {1, 4, 0.3}, {7, 3, 0.2}};
    const std::vector<RangeCorrection> after = corrected(before, calibration);
    QVERIFY((after == std::vector<RangeCorrection>{{1, 3, -0.01}, {1, 4, 0.3}, {7, 3, 0.2}, {0, 3, 0.04}}));
}

void CorrectionTableTest::aCalibrationShowsWhatIsThereAndWhatWasFound()
{
    RangeCalibrationModel model;
    const Tester tester(&model, Tester::FailureReportingMode::QtTest);
    RangeCalibrationSnapshot calibration;
    calibration.tag = 3;
    calibration.rows = {{1, 1300, -0.014, 0.021}, {9, 1, {}, 0.0}};
    model.setResult(threeAnchors(), oneTag().corrections, calibration);
    QCOMPARE(cell(model, 0, RangeCalibrationModel::Anchor), QStringLiteral("A1"));
    QCOMPARE(cell(model, 0, RangeCalibrationModel::Count), QStringLiteral("1,300"));
    QCOMPARE(cell(model, 0, RangeCalibrationModel::Present), QChar(0x2212) + QStringLiteral("5.2"));
    QCOMPARE(cell(model, 0, RangeCalibrationModel::Found), QChar(0x2212) + QStringLiteral("1.4"));
    QCOMPARE(cell(model, 0, RangeCalibrationModel::Spread), QStringLiteral("21"));
    QCOMPARE(cell(model, 1, RangeCalibrationModel::Found), QStringLiteral("–"));
    model.clear();
    QCOMPARE(model.rowCount(), 0);
}

void CorrectionTableTest::floorTagsAreFoundByNumberOrLastDigits()
{
    PlantLayout plant;
    plant.floorTags = tagGrid(2, 3, 0.1, {}, {0xE00401503B0000A1});
    QCOMPARE(floorTagsNamed(QStringLiteral("2"), plant).size(), std::size_t{1});
    QCOMPARE(floorTagsNamed(QStringLiteral(" 2 "), plant)[0]->number, 2);
    QCOMPARE(floorTagsNamed(QStringLiteral("0a3"), plant)[0]->number, 3);
    QCOMPARE(floorTagsNamed(QStringLiteral("ffff"), plant).size(), std::size_t{0});
    QCOMPARE(floorTagsNamed(QString(), plant).size(), std::size_t{0});
}

QTEST_GUILESS_MAIN(CorrectionTableTest)
#include "test_correction_table.moc"
