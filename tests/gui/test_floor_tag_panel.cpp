// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/floor_tag_panel.h"
#include "gui/hint_table_view.h"
#include "gui/map/map_widget.h"
#include "gui/window_fixture.h"

#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>

using namespace agv;
using namespace agv::gui;
using model::FloorTagState;
using model::FloorTagTableModel;

class FloorTagPanelTest : public WindowFixture {
    Q_OBJECT

private slots:
    void everyTagOfThePlantIsListed();
    void theFilterFindsATagByNumberAndUid();
    void theStateChoosesWhatIsReadNow();
    void aFilterThatFitsNothingSaysSo();
    void enterShowsTheTagOnTheMap();
    void theRowsInSightAreCopiedAsCsv();
    void theChoiceOfColumnsIsKept();

protected:
    void prepare() override
    {
        find<QDockWidget>("floorTagsDock")->raise();
        QCoreApplication::processEvents();
    }

private:
    HintTableView* table() const { return find<HintTableView>("floorTagTable"); }
    int rows() const { return table()->model()->rowCount(); }
    void filter(const QString& text) const { find<QLineEdit>("filterEdit")->setText(text); }
};

void FloorTagPanelTest::everyTagOfThePlantIsListed()
{
    QCOMPARE(rows(), 1271);
    QVERIFY(table()->isVisible());
}

void FloorTagPanelTest::theFilterFindsATagByNumberAndUid()
{
    const FloorTag tag = scenes::wholePlant().floorTags[41];
    filter(QString::fromStdString(fullText(tag.uid)));
    QCOMPARE(rows(), 1);
    QCOMPARE(table()->model()->index(0, FloorTagTableModel::Number).data().toString(),
             QString::number(tag.number));
    filter(QStringLiteral("  "));
    QCOMPARE(rows(), 1271);
}

void FloorTagPanelTest::theStateChoosesWhatIsReadNow()
{
    PlantSnapshot snapshot = scenes::linksUp();
    snapshot.time = Time{std::chrono::seconds(50)};
    for (AgvSnapshot& agv : snapshot.agvs)
        agv.recentReads.clear();
    const TagUid uid = scenes::wholePlant().floorTags[99].uid;
    snapshot.agvs[0].recentReads.push_back({snapshot.time, uid, 3});
    m_window->showSnapshot(snapshot);
    auto* states = find<QComboBox>("stateCombo");
    states->setCurrentIndex(states->findData(static_cast<int>(FloorTagState::SeenNow)));
    QCOMPARE(rows(), 1);
    QCOMPARE(table()->model()->index(0, FloorTagTableModel::Uid).data().toString(),
             QString::fromStdString(fullText(uid)));
}

void FloorTagPanelTest::aFilterThatFitsNothingSaysSo()
{
    filter(QStringLiteral("no such tag"));
    QCOMPARE(rows(), 0);
    QVERIFY(table()->showsHint());
    QCOMPARE(table()->hint(), QStringLiteral("No floor tag fits the filter."));
}

void FloorTagPanelTest::enterShowsTheTagOnTheMap()
{
    const FloorTag tag = scenes::wholePlant().floorTags[500];
    filter(QString::fromStdString(fullText(tag.uid)));
    emit table() -> activated(table()->model()->index(0, 0));
    const auto* map = find<MapWidget>("map");
    QCOMPARE(map->viewport().centre(), tag.position);
    QVERIFY(map->viewport().scale() >= 600.0);
}

void FloorTagPanelTest::theRowsInSightAreCopiedAsCsv()
{
    const FloorTag tag = scenes::wholePlant().floorTags[500];
    filter(QString::fromStdString(fullText(tag.uid)));
    click("copyCsvButton");
    const QStringList lines = QGuiApplication::clipboard()->text().split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), 3);
    QCOMPARE(lines[0], QStringLiteral("number,uid,x_mm,y_mm,state,read_by,rssi"));
    QCOMPARE(lines[1], QStringLiteral("%1,%2,%3,%4,Not read,,")
                           .arg(tag.number)
                           .arg(QString::fromStdString(fullText(tag.uid)))
                           .arg(1e3 * tag.position.x, 0, 'f', 1)
                           .arg(1e3 * tag.position.y, 0, 'f', 1));
}

void FloorTagPanelTest::theChoiceOfColumnsIsKept()
{
    click("columnsButton");
    QMenu* menu = find<FloorTagPanel>("floorTags")->findChild<QMenu*>(QString(), Qt::FindDirectChildrenOnly);
    QVERIFY(menu);
    QVERIFY(!menu->actions().at(FloorTagTableModel::Short)->isEnabled());
    menu->actions().at(FloorTagTableModel::Rssi)->trigger();
    QVERIFY(table()->isColumnHidden(FloorTagTableModel::Rssi));
    menu->close();
    m_window = std::make_unique<MainWindow>(scenes::wholePlant());
    QVERIFY(table()->isColumnHidden(FloorTagTableModel::Rssi));
    QVERIFY(!table()->isColumnHidden(FloorTagTableModel::Age));
}

QTEST_MAIN(FloorTagPanelTest)
#include "test_floor_tag_panel.moc"
