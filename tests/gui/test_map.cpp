// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "gui/map/map_widget.h"
#include "gui/map/viewport.h"
#include "gui/scenes.h"

#include <QWheelEvent>

#include <algorithm>
#include <cmath>

using namespace agv;
using namespace agv::gui;

namespace {

bool near(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()) < 1e-6; }
bool near(Point2 a, Point2 b) { return distance(a, b) < 1e-9; }

} // namespace

class MapTest : public QObject {
    Q_OBJECT
private slots:
    void pixelsAndPlantAreInverse();
    void northIsUp();
    void zoomKeepsThePointUnderThePointer();
    void zoomStopsAtItsLimits();
    void panMovesThePictureWithThePointer();
    void fitShowsTheWholeAreaInsideItsMargins();
    void stepsAreNice_data();
    void stepsAreNice();
    void snapshotsDoNotRepaintTheStaticLayer();
    void zoomingRepaintsTheStaticLayerOnce();
    void followingKeepsTheAgvInTheMiddle();
    void draggingEndsFollowing();
    void aClickOnAnAgvChoosesIt();
    void thePreviewIsDrawnWhileTheAgvTurns();
    void stationNamesLieOnNoTagThatIsReadAndOnNoAgv();
    void stationNamesLieOnNoOtherStation();
    void detailsNameTheTagUnderThePointer();
    void detailsNameTheAgvUnderThePointer();
    void detailsShowNoStateOfARobotThatIsGone();
    void theWholePlantStaysVisibleWhenTheWidgetGrows();
    void detailsNameTheUwbTagAndItsUncertainty();
    void detailsNameTheUwbAnchorsThatAreShown();
    void aUwbTagIsDrawnWhereItIs();

private:
    static std::unique_ptr<MapWidget> shownMap();
};

namespace {

PlantSnapshot withUwbTag(std::optional<Point2> position)
{
    PlantSnapshot snapshot;
    snapshot.uwb = UwbSnapshot{};
    UwbTagSnapshot tag;
    tag.id = 5;
    tag.agv = RobotId{1};
    tag.position = position;
    tag.covariance = {4e-4, 0.0, 1e-4};
    tag.ranges = {{0, 2.0, {}, false}, {1, 2.5, {}, false}, {2, 3.1, {}, true}, {3, 2.2, {}, false}};
    snapshot.uwb->tags.push_back(tag);
    return snapshot;
}

} // namespace

std::unique_ptr<MapWidget> MapTest::shownMap()
{
    auto map = std::make_unique<MapWidget>();
    map->setPlant(scenes::wholePlant());
    map->resize(900, 700);
    map->show();
    return map;
}

void MapTest::pixelsAndPlantAreInverse()
{
    Viewport view;
    view.setSize({800, 600});
    view.setCentre({1.5, -2.0});
    view.setScale(321.0);
    for (Point2 p : {Point2{0, 0}, Point2{3, 4}, Point2{-1.25, 7.5}})
        QVERIFY(near(view.toPlant(view.toPixels(p)), p));
    QVERIFY(near(view.toPixels(Point2{1.5, -2.0}), QPointF(400, 300)));
}

void MapTest::northIsUp()
{
    Viewport view;
    view.setSize({800, 600});
    QVERIFY(view.toPixels(Point2{0, 1}).y() < view.toPixels(Point2{0, 0}).y());
    QVERIFY(view.toPixels(Point2{1, 0}).x() > view.toPixels(Point2{0, 0}).x());
}

void MapTest::zoomKeepsThePointUnderThePointer()
{
    Viewport view;
    view.setSize({800, 600});
    const QPointF pointer(123, 456);
    const Point2 before = view.toPlant(pointer);
    view.zoomAt(pointer, 3.7);
    QVERIFY(near(view.toPlant(pointer), before));
    QCOMPARE(view.scale(), 370.0);
}

void MapTest::zoomStopsAtItsLimits()
{
    Viewport view;
    view.setSize({800, 600});
    const Point2 before = view.toPlant({10, 10});
    view.zoomAt({10, 10}, 1e9);
    QCOMPARE(view.scale(), Viewport::maxScale);
    QVERIFY(near(view.toPlant({10, 10}), before));
    view.zoomAt({10, 10}, 1e-9);
    QCOMPARE(view.scale(), Viewport::minScale);
}

void MapTest::panMovesThePictureWithThePointer()
{
    Viewport view;
    view.setSize({800, 600});
    const QPointF before = view.toPixels(Point2{1, 2});
    view.pan({30, -12});
    QVERIFY(near(view.toPixels(Point2{1, 2}), before + QPointF(30, -12)));
}

void MapTest::fitShowsTheWholeAreaInsideItsMargins()
{
    Viewport view;
    view.setSize({800, 600});
    view.fit(QRectF(0, 0, 3, 4), {50, 10, 20, 30});
    const QPointF southWest = view.toPixels(Point2{0, 0});
    const QPointF northEast = view.toPixels(Point2{3, 4});
    QVERIFY(southWest.x() >= 50 - 1e-6 && northEast.x() <= 780 + 1e-6);
    QVERIFY(std::abs(northEast.y() - 10) < 1e-6 && std::abs(southWest.y() - 570) < 1e-6);
    QVERIFY(std::abs((southWest.x() - 50) - (780 - northEast.x())) < 1e-6);
}

void MapTest::stepsAreNice_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("step");
    QTest::newRow("just below 1") << 0.999 << 0.5;
    QTest::newRow("1") << 1.0 << 1.0;
    QTest::newRow("1.9") << 1.9 << 1.0;
    QTest::newRow("4.9") << 4.9 << 2.0;
    QTest::newRow("70") << 70.0 << 50.0;
    QTest::newRow("small") << 0.0023 << 0.002;
}

void MapTest::stepsAreNice()
{
    QFETCH(double, value);
    QFETCH(double, step);
    QVERIFY(std::abs(niceStepBelow(value) - step) < 1e-12);
}

void MapTest::snapshotsDoNotRepaintTheStaticLayer()
{
    const auto map = shownMap();
    map->showSnapshot(scenes::linksUp());
    map->grab();
    const int statics = map->staticPaintCount();
    const int frames = map->framePaintCount();
    for (const PlantSnapshot& snapshot : {scenes::turning(), scenes::finished(), scenes::ambiguous()}) {
        map->showSnapshot(snapshot);
        map->grab();
    }
    QVERIFY(map->framePaintCount() >= frames + 3);
    QCOMPARE(map->staticPaintCount(), statics);
}

void MapTest::zoomingRepaintsTheStaticLayerOnce()
{
    const auto map = shownMap();
    map->grab();
    const int before = map->staticPaintCount();
    map->zoomIn();
    map->grab();
    map->grab();
    QCOMPARE(map->staticPaintCount(), before + 1);
}

void MapTest::followingKeepsTheAgvInTheMiddle()
{
    const auto map = shownMap();
    map->setSelectedRobot(2);
    PlantSnapshot snapshot = scenes::finished();
    map->showSnapshot(snapshot);
    map->setFollowing(true);
    QVERIFY(near(map->viewport().centre(), snapshot.agvs[1].pose->position));
    snapshot.agvs[1].pose->position = {1.0, 1.0};
    map->showSnapshot(snapshot);
    QVERIFY(near(map->viewport().centre(), Point2{1.0, 1.0}));
}

void MapTest::draggingEndsFollowing()
{
    const auto map = shownMap();
    map->setSelectedRobot(2);
    map->showSnapshot(scenes::finished());
    map->setFollowing(true);
    QSignalSpy following(map.get(), &MapWidget::followingChanged);
    QTest::mousePress(map.get(), Qt::LeftButton, {}, {300, 300});
    QTest::mouseMove(map.get(), {340, 320});
    QTest::mouseRelease(map.get(), Qt::LeftButton, {}, {340, 320});
    QCOMPARE(following.count(), 1);
    QCOMPARE(following[0][0].toBool(), false);
}

void MapTest::aClickOnAnAgvChoosesIt()
{
    const auto map = shownMap();
    const PlantSnapshot snapshot = scenes::finished();
    map->showSnapshot(snapshot);
    QSignalSpy clicks(map.get(), &MapWidget::robotClicked);
    QTest::mouseClick(map.get(), Qt::LeftButton, {},
                      map->viewport().toPixels(snapshot.agvs[2].pose->position).toPoint());
    QCOMPARE(clicks.count(), 1);
    QCOMPARE(clicks[0][0].toInt(), 3);
}

void MapTest::thePreviewIsDrawnWhileTheAgvTurns()
{
    const auto map = shownMap();
    const PlantSnapshot snapshot = scenes::turning();
    map->showSnapshot(snapshot);
    QVERIFY(!snapshot.agvs[0].pose);
    QCOMPARE(*map->drawnPose(1), snapshot.agvs[0].turn.preview->pose);
    QVERIFY(!map->drawnPose(2));
}

void MapTest::stationNamesLieOnNoTagThatIsReadAndOnNoAgv()
{
    const auto map = shownMap();
    PlantSnapshot snapshot = scenes::linksUp();
    const PlantLayout plant = scenes::wholePlant();
    const std::vector<QRectF> before = map->stationNames();
    QCOMPARE(before.size(), plant.stations.size());
    // An AGV stands on the name of the mixing station, another reads a tag on that of the first dock.
    snapshot.agvs[0].pose = Pose2{map->viewport().toPlant(before[2].center()), 0.0};
    const Point2 dock = map->viewport().toPlant(before[4].center());
    const auto tag = std::min_element(plant.floorTags.begin(), plant.floorTags.end(),
                                      [&](const FloorTag& a, const FloorTag& b) {
                                          return distance(a.position, dock) < distance(b.position, dock);
                                      });
    snapshot.agvs[1].recentReads.push_back({snapshot.time, tag->uid, 3});
    map->showSnapshot(snapshot);
    const std::vector<QRectF> names = map->stationNames();
    const double half = map->readSize();
    const QRectF diamond(map->viewport().toPixels(tag->position) - QPointF(half, half),
                         QSizeF(2.0 * half, 2.0 * half));
    QVERIFY(before[4].intersects(diamond));
    for (const QRectF& name : names) {
        QVERIFY(!name.intersects(diamond));
        QVERIFY(!name.contains(map->viewport().toPixels(snapshot.agvs[0].pose->position)));
    }
    map->showSnapshot(scenes::linksUp());
    QVERIFY(map->stationNames() == before);
}

void MapTest::stationNamesLieOnNoOtherStation()
{
    const auto map = shownMap();
    const PlantLayout plant = scenes::wholePlant();
    const std::vector<QRectF> names = map->stationNames();
    for (std::size_t name = 0; name < names.size(); ++name) {
        for (std::size_t other = 0; other < plant.stations.size(); ++other)
            QVERIFY(other == name ||
                    !names[name].contains(map->viewport().toPixels(plant.stations[other].pose.position)));
    }
}

void MapTest::detailsNameTheTagUnderThePointer()
{
    const auto map = shownMap();
    const QString details = map->detailsAt(map->viewport().toPixels(Point2{0.0, 0.1}));
    QVERIFY2(details.contains(QStringLiteral("E00401503B000002")), qPrintable(details));
}

void MapTest::detailsNameTheAgvUnderThePointer()
{
    const auto map = shownMap();
    const PlantSnapshot snapshot = scenes::finished();
    map->showSnapshot(snapshot);
    const QString details = map->detailsAt(map->viewport().toPixels(snapshot.agvs[1].pose->position));
    QVERIFY2(details.startsWith(QStringLiteral("AGV 2")), qPrintable(details));
    QVERIFY2(details.contains(QStringLiteral("Idle")), qPrintable(details));
}

void MapTest::detailsShowNoStateOfARobotThatIsGone()
{
    const auto map = shownMap();
    PlantSnapshot snapshot = scenes::finished();
    AgvSnapshot& agv = snapshot.agvs[1];
    const QPointF there = map->viewport().toPixels(agv.pose->position);
    agv.robotState.reset();
    map->showSnapshot(snapshot);
    QVERIFY(map->detailsAt(there).contains(QStringLiteral("State unknown")));
    agv.robotState = RobotState::DirectDriving;
    agv.robotLink.state = LinkState::Waiting;
    map->showSnapshot(snapshot);
    QVERIFY(map->detailsAt(there).contains(QStringLiteral("Not connected")));
    QVERIFY(!map->detailsAt(there).contains(QStringLiteral("Driving")));
}

void MapTest::theWholePlantStaysVisibleWhenTheWidgetGrows()
{
    const auto map = shownMap();
    map->resize(500, 400);
    map->grab();
    QVERIFY(map->viewport().visibleArea().contains(areaOf(scenes::wholePlant())));
}

void MapTest::detailsNameTheUwbTagAndItsUncertainty()
{
    const auto map = shownMap();
    map->showSnapshot(withUwbTag(Point2{1.23, 2.34}));
    const QString details = map->detailsAt(map->viewport().toPixels(Point2{1.23, 2.34}));
    for (const char* text :
         {"UWB tag 5", "On AGV 1", "49\u00a0mm by 24\u00a0mm", "4 ranges, 1 of them obstructed"})
        QVERIFY2(details.contains(QString::fromUtf8(text)), qPrintable(details));
    map->showSnapshot(withUwbTag({}));
    QVERIFY(!map->detailsAt(map->viewport().toPixels(Point2{1.23, 2.34})).contains("UWB tag"));
}

void MapTest::detailsNameTheUwbAnchorsThatAreShown()
{
    PlantLayout plant = scenes::wholePlant();
    plant.anchors = {{7, "North", 1.0, 1.0, 2.5, true}, {8, "Hidden", 2.0, 2.0, 2.5, false}};
    MapWidget map;
    map.resize(900, 700);
    map.setPlant(plant);
    const QString details = map.detailsAt(map.viewport().toPixels(Point2{1.0, 1.0}));
    QVERIFY2(details.contains("UWB anchor 7, North") && details.contains(QStringLiteral("500\u00a0mm")),
             qPrintable(details));
    QVERIFY(!map.detailsAt(map.viewport().toPixels(Point2{2.0, 2.0})).contains("UWB anchor"));
}

void MapTest::aUwbTagIsDrawnWhereItIs()
{
    const auto map = shownMap();
    const QPoint at = map->viewport().toPixels(Point2{1.23, 2.34}).toPoint();
    const QImage before = map->grab().toImage();
    map->showSnapshot(withUwbTag(Point2{1.23, 2.34}));
    const QImage after = map->grab().toImage();
    const double ratio = before.devicePixelRatio();
    const auto pixel = [&](const QImage& image, QPoint p) {
        return image.pixel((QPointF(p) * ratio).toPoint());
    };
    QVERIFY(pixel(before, at) != pixel(after, at));
    QCOMPARE(pixel(before, at + QPoint(150, 0)), pixel(after, at + QPoint(150, 0)));
}

QTEST_MAIN(MapTest)
#include "test_map.moc"
