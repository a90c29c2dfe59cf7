// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "model/uwb_kit_tables.h"
#include "model/uwb_tag_table_model.h"

using namespace agv;
using namespace agv::kit;
using namespace agv::model;
using Tags = UwbTagTableModel;

/// The UWB tags as a table.
class UwbTagTableTest : public QObject {
    Q_OBJECT
private slots:
    void init() { QLocale::setDefault(QLocale(QStringLiteral("en_GB"))); }
    void tagsShowTheirFixRangesAndRepeatability();
    void aTagWithoutAPositionSaysWhy();
    void aListedTagThatIsNotHeardSaysSo();
    void anEditOfATagThatIsOnlyHeardListsIt();
    void theAgvOfATagIsChosenByNameOrNumberOrTakenAway();
    void badInputForATagIsRefusedWithASentence();
    void aTagThatIsHeardForTheFirstTimeLeavesTheOtherRowsInPlace();
    void tagsChangeUnderTheModelTester();
    void repeatabilitySaysThatItIsNotAccuracy();
};

void UwbTagTableTest::tagsShowTheirFixRangesAndRepeatability()
{
    UwbTagTableModel model;
    model.setAgvs(twoAgvs());
    model.setSettings(threeAnchors(), oneTag());
    const UwbSnapshot uwb = heard();
    model.setSnapshot(&uwb);
    QCOMPARE(model.columnCount(), Tags::FirstRange + 3);
    QCOMPARE(cell(model, 0, Tags::Label), QStringLiteral("Lift"));
    QCOMPARE(cell(model, 0, Tags::Height), QStringLiteral("450"));
    QCOMPARE(cell(model, 0, Tags::Uncertainty), QStringLiteral("25")); // 24.5, rounded up
    QCOMPARE(cell(model, 0, Tags::Repeatability), QStringLiteral("43"));
    QCOMPARE(cell(model, 0, Tags::State), QStringLiteral("Fix"));
    QCOMPARE(cell(model, 0, Tags::FirstRange), QStringLiteral("1,500"));
    QCOMPARE(cell(model, 0, Tags::FirstRange + 1), QStringLiteral("–"));
    // Marked by a sign, and explained.
    QCOMPARE(cell(model, 0, Tags::FirstRange + 2), QChar(0x2715) + QStringLiteral(" 3,900"));
    QVERIFY(model.index(0, Tags::FirstRange + 2)
                .data(Qt::ToolTipRole)
                .toString()
                .startsWith(QStringLiteral("Not used")));
}

void UwbTagTableTest::aTagWithoutAPositionSaysWhy()
{
    UwbTagTableModel model;
    model.setSettings(threeAnchors(), oneTag());
    const UwbSnapshot uwb = heard();
    model.setSnapshot(&uwb);
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(cell(model, 1, Tags::Id), QStringLiteral("5"));
    QCOMPARE(cell(model, 1, Tags::Label), QStringLiteral("not listed"));
    QCOMPARE(cell(model, 1, Tags::X), QStringLiteral("–"));
    QCOMPARE(cell(model, 1, Tags::State), QStringLiteral("No anchor that is known is in its reports"));
    QVERIFY(model.index(1, Tags::State).data(Tags::WarningRole).toBool());
    QVERIFY(!model.index(0, Tags::State).data(Tags::WarningRole).toBool());
}

void UwbTagTableTest::aListedTagThatIsNotHeardSaysSo()
{
    UwbTagTableModel model;
    model.setSettings(threeAnchors(), oneTag());
    QCOMPARE(cell(model, 0, Tags::State), QStringLiteral("Not heard"));
    QCOMPARE(cell(model, 0, Tags::Age), QStringLiteral("–"));
    QVERIFY(!model.index(0, Tags::State).data(Tags::WarningRole).toBool());
}

void UwbTagTableTest::anEditOfATagThatIsOnlyHeardListsIt()
{
    UwbTagTableModel model;
    model.setAgvs(twoAgvs());
    model.setSettings(threeAnchors(), oneTag());
    const UwbSnapshot uwb = heard();
    model.setSnapshot(&uwb);
    QSignalSpy edits(&model, &Tags::editRequested);
    QVERIFY(!enter(model, 1, Tags::Id, QStringLiteral("9"))); // its number is what it says
    QVERIFY(enter(model, 1, Tags::Height, QStringLiteral("600")));
    QCOMPARE(edits.count(), 1);
    QCOMPARE(edits[0][0].toString(), QStringLiteral("List UWB tag 5"));
    const auto tags = edits[0][1].value<std::vector<UwbTag>>();
    QCOMPARE(tags.size(), std::size_t{2});
    QCOMPARE(tags[1].id, 5);
    QCOMPARE(tags[1].z_m, 0.6);
    QCOMPARE(tags[1].label, std::string("T5"));
}

void UwbTagTableTest::theAgvOfATagIsChosenByNameOrNumberOrTakenAway()
{
    UwbTagTableModel model;
    model.setAgvs(twoAgvs());
    UwbSettings settings = oneTag();
    model.setSettings(threeAnchors(), settings);
    QCOMPARE(model.index(0, Tags::Agv).data(Tags::ChoicesRole).toStringList(),
             QStringList({QStringLiteral("–"), QStringLiteral("Mover"), QStringLiteral("AGV 2")}));
    QSignalSpy edits(&model, &Tags::editRequested);
    QVERIFY(enter(model, 0, Tags::Agv, QStringLiteral("mover")));
    QCOMPARE(edits[0][1].value<std::vector<UwbTag>>()[0].agv, std::optional(RobotId{1}));
    QVERIFY(enter(model, 0, Tags::Agv, QStringLiteral("2")));
    QCOMPARE(edits[1][1].value<std::vector<UwbTag>>()[0].agv, std::optional(RobotId{2}));
    settings.tags[0].agv = RobotId{2};
    model.setSettings(threeAnchors(), settings);
    QVERIFY(enter(model, 0, Tags::Agv, QStringLiteral("–")));
    QVERIFY(!edits[2][1].value<std::vector<UwbTag>>()[0].agv);
}

void UwbTagTableTest::badInputForATagIsRefusedWithASentence()
{
    UwbTagTableModel model;
    model.setAgvs(twoAgvs());
    UwbSettings settings = oneTag();
    settings.tags.push_back(settings.tags[0]);
    settings.tags[1].id = 4;
    model.setSettings(threeAnchors(), settings);
    QSignalSpy edits(&model, &Tags::editRequested);
    QSignalSpy refusals(&model, &Tags::refused);
    QVERIFY(!enter(model, 0, Tags::Agv, QStringLiteral("AGV 9")));
    QVERIFY(!enter(model, 0, Tags::Height, QStringLiteral("tall")));
    QVERIFY(!enter(model, 0, Tags::Id, QStringLiteral("4")));
    QVERIFY(!enter(model, 0, Tags::Id, QStringLiteral("-1")));
    QCOMPARE(edits.count(), 0);
    QCOMPARE(refusals.count(), 4);
    QVERIFY(refusals[0][0].toString().contains(QStringLiteral("There is no AGV \"AGV 9\"")));
    QVERIFY(refusals[2][0].toString().contains(QStringLiteral("There is a UWB tag 4 already")));
}

void UwbTagTableTest::aTagThatIsHeardForTheFirstTimeLeavesTheOtherRowsInPlace()
{
    UwbTagTableModel model;
    const Tester tester(&model, Tester::FailureReportingMode::QtTest);
    model.setSettings(threeAnchors(), oneTag());
    UwbSnapshot uwb = heard();
    model.setSnapshot(&uwb);
    QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
    const QPersistentModelIndex edited = model.index(1, Tags::Label); // tag 5
    UwbTagSnapshot other;
    other.id = 4;
    uwb.tags.push_back(other);
    model.setSnapshot(&uwb);
    QCOMPARE(edited.row(), 2);
    QCOMPARE(edited.data(Tags::TagRole).toInt(), 5);
    // Listing it moves it before the others that are only heard.
    QSignalSpy edits(&model, &Tags::editRequested);
    QVERIFY(model.setData(edited, QStringLiteral("Fork"), Qt::EditRole));
    uwb.tags.pop_back();
    model.setSnapshot(&uwb);
    QCOMPARE(edited.row(), 1);
    QCOMPARE(resets.count(), 0);
    UwbSettings settings = oneTag();
    settings.tags = edits[0][1].value<std::vector<UwbTag>>();
    model.setSettings(threeAnchors(), settings);
    QCOMPARE(cell(model, 1, Tags::Label), QStringLiteral("Fork"));
}

void UwbTagTableTest::tagsChangeUnderTheModelTester()
{
    UwbTagTableModel model;
    const Tester tester(&model, Tester::FailureReportingMode::QtTest);
    UwbSnapshot uwb = heard();
    model.setSnapshot(&uwb);
    model.setSettings(threeAnchors(), oneTag());
    std::vector<UwbAnchor> anchors = threeAnchors();
    anchors.pop_back();
    model.setSettings(anchors, oneTag());
    anchors[0].id = 9;
    model.setSettings(anchors, oneTag());
    uwb.tags.pop_back();
    model.setSnapshot(&uwb);
    model.setSnapshot(nullptr);
    model.setSettings({}, {});
    QCOMPARE(model.rowCount(), 0);
    QCOMPARE(model.columnCount(), int(Tags::FirstRange));
}

void UwbTagTableTest::repeatabilitySaysThatItIsNotAccuracy()
{
    const UwbTagTableModel model;
    const auto header = [&model](int role) {
        return model.headerData(Tags::Repeatability, Qt::Horizontal, role).toString();
    };
    QCOMPARE(header(Qt::DisplayRole), QStringLiteral("R95 (mm)"));
    QVERIFY(header(Qt::ToolTipRole).startsWith(QStringLiteral("Repeatability")));
    QVERIFY(header(Qt::ToolTipRole).contains(QStringLiteral("nothing of how far")));
}

QTEST_GUILESS_MAIN(UwbTagTableTest)
#include "test_uwb_tag_table.moc"
