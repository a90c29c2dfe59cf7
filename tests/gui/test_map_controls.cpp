// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/map_widget.h"
#include "gui/picture_file.h"
#include "gui/uwb_fixture.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QFile>
#include <QFileDialog>
#include <QImageReader>
#include <QMenu>
#include <QPainter>
#include <QTableView>

using namespace agv;
using namespace agv::gui;

class MapControlsTest : public UwbFixture {
    Q_OBJECT

private slots:
    void everyLayerHasASwitchThatChangesThePicture_data();
    void everyLayerHasASwitchThatChangesThePicture();
    void layersAndTrailLengthAreKeptForTheNextStart();
    void aDistanceIsMeasuredFromTagToTag();
    void aDistanceIsMeasuredByADrag();
    void endingTheToolTakesTheLineAway();
    void anAnchorIsDraggedInStepsOfTenMillimetresAndUndone();
    void anAnchorStaysWhereItIsWithoutTheTool();
    void aClickedUwbTagShowsItsRanges();
    void aClickOnTheOverviewMovesTheMap();
    void theMenuUnderThePointerCopiesThePlace();
    void thePictureIsSavedAs_data();
    void thePictureIsSavedAs();
    void aPictureThatCannotBeSavedSaysWhy();
    void thePictureIsCopied();

private:
    MapWidget* map() const { return find<MapWidget>("map"); }
    QPoint pixel(Point2 place) const { return map()->viewport().toPixels(place).toPoint(); }
    Point2 tag(std::size_t i) const { return scenes::uwbPlant().floorTags[i].position; }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) const
    {
        QTest::mousePress(map(), Qt::LeftButton, modifiers, from);
        for (int i = 1; i <= 4; ++i) {
            const QPointF at = QPointF(from) + 0.25 * i * QPointF(to - from);
            QMouseEvent move(QEvent::MouseMove, at, map()->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                             modifiers);
            QCoreApplication::sendEvent(map(), &move);
        }
        QTest::mouseRelease(map(), Qt::LeftButton, modifiers, to);
    }
};

void MapControlsTest::everyLayerHasASwitchThatChangesThePicture_data()
{
    QTest::addColumn<QString>("action");
    for (const char* action :
         {"gridAction", "tagsAction", "stationsAction", "anchorsAction", "uwbTagsAction", "trailsAction",
          "uncertaintyAction", "rangesAction", "accuracyAction", "minimapAction"})
        QTest::newRow(action) << QString::fromLatin1(action);
}

void MapControlsTest::everyLayerHasASwitchThatChangesThePicture()
{
    QFETCH(QString, action);
    openRunning();
    PlantSnapshot moved = scenes::uwbRunning();
    for (int i = 0; i < 20; ++i) {
        moved.time += std::chrono::milliseconds(100);
        for (UwbTagSnapshot& each : moved.uwb->tags) {
            if (each.position)
                each.position->x += 0.02;
        }
        m_window->showSnapshot(moved);
    }
    if (action == QLatin1String("minimapAction"))
        map()->zoomIn();
    const QImage before = map()->grab().toImage();
    trigger(action.toLatin1().constData());
    QVERIFY(map()->grab().toImage() != before);
    trigger(action.toLatin1().constData());
    QCOMPARE(map()->grab().toImage(), before);
}

void MapControlsTest::layersAndTrailLengthAreKeptForTheNextStart()
{
    openRunning();
    trigger("accuracyAction");
    trigger("stationsAction");
    trigger("trail2mAction");
    openRunning();
    QVERIFY(map()->layers().accuracy);
    QVERIFY(!map()->layers().stations);
    QCOMPARE(map()->trailLimit(), (TrailLimit{{}, 2.0}));
    QVERIFY(find<QAction>("trail2mAction")->isChecked());
}

void MapControlsTest::aDistanceIsMeasuredFromTagToTag()
{
    openRunning();
    trigger("measureAction");
    // Two pixels beside the tags: the ends lie on them exactly.
    QTest::mouseClick(map(), Qt::LeftButton, {}, pixel(tag(0)) + QPoint(2, 1));
    QTest::mouseClick(map(), Qt::LeftButton, {}, pixel(tag(40)) + QPoint(-1, 2));
    QVERIFY(map()->measured().has_value());
    QCOMPARE(map()->measured()->from, tag(0));
    QCOMPARE(map()->measured()->to, tag(40));
}

void MapControlsTest::aDistanceIsMeasuredByADrag()
{
    openRunning();
    trigger("measureAction");
    const Point2 centre = map()->viewport().centre();
    drag(pixel(tag(0)), pixel(tag(40)));
    QVERIFY(map()->measured().has_value());
    QCOMPARE(map()->measured()->from, tag(0));
    QCOMPARE(map()->measured()->to, tag(40));
    QCOMPARE(map()->viewport().centre(), centre); // the picture stayed
    QTest::mouseMove(map(), pixel(tag(20)));
    QCOMPARE(map()->measured()->to, tag(40)); // the drag was the whole of it
}

void MapControlsTest::endingTheToolTakesTheLineAway()
{
    openRunning();
    trigger("measureAction");
    drag(pixel(tag(0)), pixel(tag(40)));
    trigger("measureAction");
    QVERIFY(!map()->measured());
    QCOMPARE(map()->tool(), MapTool::Select);
}

void MapControlsTest::anAnchorIsDraggedInStepsOfTenMillimetresAndUndone()
{
    openRunning();
    const std::vector<UwbAnchor> before = scenes::uwbPlant().anchors;
    trigger("moveAnchorsAction");
    const Point2 place{before[0].x, before[0].y};
    const Point2 target = map()->viewport().toPlant(pixel(place) + QPoint(60, -60));
    drag(pixel(place), pixel(target));
    QCOMPARE(m_edited.size(), std::size_t{1});
    const UwbAnchor moved = m_edited.back().first[0];
    QVERIFY(std::abs(moved.x - target.x) < 0.011 && std::abs(moved.y - target.y) < 0.011);
    QVERIFY(std::abs(moved.x * 100.0 - std::round(moved.x * 100.0)) < 1e-9);
    QCOMPARE(moved.z, before[0].z);
    QVERIFY(undoes(before, scenes::uwbPlant().uwb));
}

void MapControlsTest::anAnchorStaysWhereItIsWithoutTheTool()
{
    openRunning();
    const UwbAnchor anchor = scenes::uwbPlant().anchors[0];
    const Point2 place{anchor.x, anchor.y};
    drag(pixel(place), pixel(place) + QPoint(60, -60));
    QVERIFY(m_edited.empty());
}

void MapControlsTest::aClickedUwbTagShowsItsRanges()
{
    openRunning();
    trigger("rangesAction");
    const PlantSnapshot running = scenes::uwbRunning();
    const auto placed = std::ranges::find_if(
        running.uwb->tags, [](const UwbTagSnapshot& each) { return each.position.has_value(); });
    QTest::mouseClick(map(), Qt::LeftButton, {}, pixel(*placed->position));
    QVERIFY(map()->shownUwbTag());
    QCOMPARE(map()->shownUwbTag()->id, placed->id);
}

void MapControlsTest::aClickOnTheOverviewMovesTheMap()
{
    openRunning();
    for (int i = 0; i < 6; ++i)
        map()->zoomIn();
    const Minimap minimap;
    const QRectF area = areaOf(scenes::uwbPlant());
    const QRectF place = minimap.place(map()->viewport(), area).value();
    const QPoint at = place.center().toPoint() - QPoint(0, 30);
    const Point2 there = minimap.plantPointAt(at, map()->viewport(), area).value();
    QTest::mouseClick(map(), Qt::LeftButton, {}, at);
    QCOMPARE(map()->viewport().centre(), there);
}

void MapControlsTest::theMenuUnderThePointerCopiesThePlace()
{
    openRunning();
    const QPoint at = pixel(tag(7));
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, map()->mapToGlobal(at));
    QCoreApplication::sendEvent(map(), &event);
    QMenu* menu = nullptr;
    for (QMenu* each : m_window->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (each->objectName().isEmpty())
            menu = each;
    }
    QVERIFY(menu);
    menu->actions().first()->trigger();
    QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("x ")));
    menu->actions().at(1)->trigger();
    QCOMPARE(map()->tool(), MapTool::Measure);
    QCOMPARE(map()->measured()->from, tag(7));
    QVERIFY(find<QAction>("measureAction")->isChecked());
    menu->close();
}

void MapControlsTest::thePictureIsSavedAs_data()
{
    QTest::addColumn<QString>("ending");
    QTest::addColumn<QByteArray>("beginning");
    QTest::newRow("png") << "png" << QByteArray("\x89PNG");
    QTest::newRow("svg") << "svg" << QByteArray("<?xml");
    QTest::newRow("pdf") << "pdf" << QByteArray("%PDF");
}

void MapControlsTest::thePictureIsSavedAs()
{
    QFETCH(QString, ending);
    QFETCH(QByteArray, beginning);
    openRunning();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("map.") + ending);
    trigger("saveMapAction");
    emit find<QFileDialog>("mapPictureDialog")->fileSelected(path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QVERIFY(bytes.startsWith(beginning));
    QVERIFY(bytes.size() > 2000);
    if (ending == QLatin1String("png"))
        QCOMPARE(QImageReader(path).size(), map()->size() * 2);
}

void MapControlsTest::aPictureThatCannotBeSavedSaysWhy()
{
    const auto nothing = [](QPainter&) {};
    const Result<void> folder = savePicture(QStringLiteral("/no/such/folder/map.png"), {10, 10}, nothing);
    QVERIFY(!folder.has_value());
    QVERIFY(QString::fromStdString(folder.error().detail)
                .startsWith(QStringLiteral("/no/such/folder/map.png: ")));
    const QTemporaryDir other;
    const Result<void> ending = savePicture(other.filePath(QStringLiteral("map.bmp")), {10, 10}, nothing);
    QVERIFY(!ending.has_value());
    QVERIFY(
        QString::fromStdString(ending.error().detail).endsWith(QStringLiteral("ends in .png, .svg or .pdf")));
    QVERIFY(!QFile::exists(other.filePath(QStringLiteral("map.bmp"))));
}

void MapControlsTest::thePictureIsCopied()
{
    openRunning();
    trigger("copyMapAction");
    QCOMPARE(QGuiApplication::clipboard()->image().size(), map()->grab().size());
}

QTEST_MAIN(MapControlsTest)
#include "test_map_controls.moc"
