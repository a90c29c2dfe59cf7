// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "model/anchor_table_model.h"
#include "model/uwb_kit_tables.h"

using namespace agv;
using namespace agv::kit;
using namespace agv::model;
using Anchors = AnchorTableModel;

/// The anchors of the plant as a table.
class AnchorTableTest : public QObject {
    Q_OBJECT
private slots:
    void init() { QLocale::setDefault(QLocale(QStringLiteral("en_GB"))); }
    void anchorsShowTheirPlaceInMillimetresAndTheirLiveFigures();
    void anAnchorThatWasNeverHeardShowsNoFigures();
    void aDoubtedAnchorAsksForAttentionInWords();
    void anEditOfAnAnchorIsAskedForAndNotMade();
    void everyCellOfAnAnchorCanBeEdited_data();
    void everyCellOfAnAnchorCanBeEdited();
    void badInputForAnAnchorIsRefusedWithASentence_data();
    void badInputForAnAnchorIsRefusedWithASentence();
    void aTextThatWasNotChangedIsNoEdit();
    void germanNumbersAreReadAsTheyAreShown();
    void anchorsChangeUnderTheModelTester();
};

void AnchorTableTest::anchorsShowTheirPlaceInMillimetresAndTheirLiveFigures()
{
    AnchorTableModel model;
    model.setAnchors(threeAnchors());
    const UwbSnapshot uwb = heard();
    model.setSnapshot(&uwb);
    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(cell(model, 1, Anchors::X), QStringLiteral("3,000"));
    QCOMPARE(cell(model, 0, Anchors::Rate), QStringLiteral("9.9"));
    QCOMPARE(cell(model, 0, Anchors::Residual), QStringLiteral("12"));
    QCOMPARE(cell(model, 0, Anchors::Spread), QStringLiteral("31"));
    QCOMPARE(cell(model, 2, Anchors::Residual), QChar(0x2212) + QStringLiteral("300"));
    QCOMPARE(model.index(0, Anchors::Shown).data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Checked));
    QCOMPARE(model.index(2, Anchors::Shown).data(Qt::CheckStateRole).toInt(),
             static_cast<int>(Qt::Unchecked));
    QVERIFY(model.headerData(Anchors::X, Qt::Horizontal, Qt::DisplayRole)
                .toString()
                .contains(QStringLiteral("(mm)")));
}

void AnchorTableTest::anAnchorThatWasNeverHeardShowsNoFigures()
{
    AnchorTableModel model;
    model.setAnchors(threeAnchors());
    const UwbSnapshot uwb = heard();
    model.setSnapshot(&uwb);
    for (int column : {Anchors::Age, Anchors::Rate, Anchors::Residual, Anchors::Spread})
        QCOMPARE(cell(model, 1, column), QStringLiteral("–"));
    model.setSnapshot(nullptr);
    QCOMPARE(cell(model, 0, Anchors::Rate), QStringLiteral("–"));
}

void AnchorTableTest::aDoubtedAnchorAsksForAttentionInWords()
{
    AnchorTableModel model;
    model.setAnchors(threeAnchors());
    const UwbSnapshot uwb = heard();
    model.setSnapshot(&uwb);
    QCOMPARE(cell(model, 2, Anchors::Warning), QStringLiteral("Ranges do not fit"));
    QVERIFY(model.index(2, Anchors::Warning).data(Anchors::WarningRole).toBool());
    QVERIFY(!model.index(0, Anchors::Warning).data(Anchors::WarningRole).toBool());
}

void AnchorTableTest::anEditOfAnAnchorIsAskedForAndNotMade()
{
    AnchorTableModel model;
    model.setAnchors(threeAnchors());
    QSignalSpy edits(&model, &Anchors::editRequested);
    QVERIFY(enter(model, 1, Anchors::X, QStringLiteral("3250.5")));
    QCOMPARE(edits.count(), 1);
    QCOMPARE(edits[0][0].toString(), QStringLiteral("Move A1"));
    const auto asked = edits[0][1].value<std::vector<UwbAnchor>>();
    QCOMPARE(asked[1].x, 3.2505);
    QCOMPARE(model.anchors()[1].x, 3.0);
}

void AnchorTableTest::everyCellOfAnAnchorCanBeEdited_data()
{
    QTest::addColumn<int>("column");
    QTest::addColumn<QString>("input");
    QTest::addColumn<QString>("what");
    QTest::newRow("id") << int(Anchors::Id) << "12" << "Renumber A0";
    QTest::newRow("label") << int(Anchors::Label) << " Door " << "Rename A0";
    QTest::newRow("x") << int(Anchors::X) << "-5" << "Move A0";
    QTest::newRow("y") << int(Anchors::Y) << QString(QChar(0x2212)) + "5" << "Move A0";
    QTest::newRow("z") << int(Anchors::Z) << "2100" << "Move A0";
}

void AnchorTableTest::everyCellOfAnAnchorCanBeEdited()
{
    QFETCH(int, column);
    QFETCH(QString, input);
    QFETCH(QString, what);
    AnchorTableModel model;
    model.setAnchors(threeAnchors());
    QVERIFY(model.flags(model.index(0, column)).testFlag(Qt::ItemIsEditable));
    QSignalSpy edits(&model, &Anchors::editRequested);
    QVERIFY(enter(model, 0, column, input));
    QCOMPARE(edits.count(), 1);
    QCOMPARE(edits[0][0].toString(), what);
    model.setAnchors(edits[0][1].value<std::vector<UwbAnchor>>());
    QCOMPARE(cell(model, 0, column).remove(QLatin1Char(',')).replace(QChar(0x2212), QLatin1Char('-')),
             input.trimmed().replace(QChar(0x2212), QLatin1Char('-')));
    QVERIFY(model.setData(model.index(2, Anchors::Shown), Qt::Checked, Qt::CheckStateRole));
    QCOMPARE(edits.last()[0].toString(), QStringLiteral("Show Anchor 7"));
}

void AnchorTableTest::badInputForAnAnchorIsRefusedWithASentence_data()
{
    QTest::addColumn<int>("column");
    QTest::addColumn<QString>("input");
    QTest::addColumn<QString>("part");
    QTest::newRow("no number") << int(Anchors::X) << "abc" << "\"abc\" is not a number: x of A0 in mm stays";
    QTest::newRow("empty") << int(Anchors::Y) << "" << "is not a number";
    QTest::newRow("not finite") << int(Anchors::Z) << "inf" << "is not a number";
    QTest::newRow("nan") << int(Anchors::Z) << "nan" << "is not a number";
    QTest::newRow("out of range") << int(Anchors::X) << "1000001" << "may be from";
    QTest::newRow("duplicate id") << int(Anchors::Id) << "7" << "There is an anchor 7 already";
    QTest::newRow("id out of range") << int(Anchors::Id) << "256" << "out of range";
    QTest::newRow("broken id") << int(Anchors::Id) << "1.5" << "not a whole number";
}

void AnchorTableTest::badInputForAnAnchorIsRefusedWithASentence()
{
    QFETCH(int, column);
    QFETCH(QString, input);
    QFETCH(QString, part);
    AnchorTableModel model;
    model.setAnchors(threeAnchors());
    QSignalSpy edits(&model, &Anchors::editRequested);
    QSignalSpy refusals(&model, &Anchors::refused);
    QVERIFY(!enter(model, 0, column, input));
    QCOMPARE(edits.count(), 0);
    QCOMPARE(refusals.count(), 1);
    QVERIFY2(refusals[0][0].toString().contains(part), qPrintable(refusals[0][0].toString()));
    QVERIFY(model.anchors() == threeAnchors());
}

void AnchorTableTest::aTextThatWasNotChangedIsNoEdit()
{
    AnchorTableModel model;
    std::vector<UwbAnchor> anchors = threeAnchors();
    anchors[0].x = 0.0123456;
    model.setAnchors(anchors);
    QSignalSpy edits(&model, &Anchors::editRequested);
    for (int column = Anchors::Id; column <= Anchors::Z; ++column)
        QVERIFY(enter(model, 0, column, model.index(0, column).data(Qt::EditRole).toString()));
    QCOMPARE(edits.count(), 0);
}

void AnchorTableTest::germanNumbersAreReadAsTheyAreShown()
{
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    AnchorTableModel model;
    model.setAnchors(threeAnchors());
    QSignalSpy edits(&model, &Anchors::editRequested);
    QVERIFY(enter(model, 0, Anchors::X, QStringLiteral("1.234,5")));
    QCOMPARE(edits[0][1].value<std::vector<UwbAnchor>>()[0].x, 1.2345);
    QVERIFY(enter(model, 0, Anchors::X, QStringLiteral("12.5")));
    QCOMPARE(edits[1][1].value<std::vector<UwbAnchor>>()[0].x, 0.0125);
}

void AnchorTableTest::anchorsChangeUnderTheModelTester()
{
    AnchorTableModel model;
    const Tester tester(&model, Tester::FailureReportingMode::QtTest);
    model.setAnchors(threeAnchors());
    const UwbSnapshot uwb = heard();
    model.setSnapshot(&uwb);
    std::vector<UwbAnchor> anchors = threeAnchors();
    anchors.erase(anchors.begin());
    model.setAnchors(anchors);
    model.setSnapshot(nullptr);
    model.setAnchors({});
    QCOMPARE(model.rowCount(), 0);
}

QTEST_GUILESS_MAIN(AnchorTableTest)
#include "test_anchor_table.moc"
