// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "gui/map/accuracy_layer.h"
#include "gui/map/floor_tag_painter.h"
#include "gui/map/map_widget.h"
#include "gui/map/measure_line.h"
#include "gui/map/minimap.h"
#include "gui/map/range_painter.h"
#include "gui/map/static_layer.h"
#include "gui/map/trails.h"
#include "gui/scenes.h"
#include "gui/uwb_scenes.h"
#include "model/words.h"

#include <QImage>
#include <QPainter>

using namespace agv;
using namespace agv::gui;

namespace {

PlantSnapshot at(double seconds, std::optional<Point2> tag, std::optional<Point2> agv = std::nullopt)
{
    PlantSnapshot snapshot;
    snapshot.time = Time{std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds))};
    snapshot.uwb = UwbSnapshot{};
    snapshot.uwb->tags.emplace_back().id = 5;
    snapshot.uwb->tags.back().position = tag;
    snapshot.agvs.emplace_back().id = RobotId{1};
    if (agv)
        snapshot.agvs.back().pose = Pose2{*agv, 0.0};
    return snapshot;
}

PlantSnapshot turned(const std::vector<TagUid>& seen, const std::vector<TagUid>& missed,
                     const std::vector<TagUid>& unknown)
{
    PlantSnapshot snapshot = scenes::finished();
    auto result = std::make_shared<TurnEstimate>(*snapshot.agvs[0].turn.result);
    result->stops.assign(1, StopReport{});
    result->stops[0].antenna = {1.0, 1.0};
    result->stops[0].seen = seen;
    result->stops[0].missed = missed;
    result->stops[0].unknown = unknown;
    snapshot.agvs[0].turn.result = result;
    for (AgvSnapshot& agv : snapshot.agvs)
        agv.recentReads.clear();
    return snapshot;
}

} // namespace

class MapMarksTest : public QObject {
    Q_OBJECT

private slots:
    void aTrailLeavesOutWhatLiesCloserThanACentimetre();
    void aTrailHoldsNoMoreThanItsMostPoints();
    void aTrailForgetsWhatIsOlderThanItsTime();
    void aTrailForgetsWhatIsFartherBackThanItsLength();
    void aPoseFoundAnewStartsTheTrailAnew();
    void aDoubtedPoseLeavesNoTrail();
    void aTagThatIsNoLongerNamedLosesItsTrail();

    void tagsAreMarkedAsSeenMissingOrUnknown();
    void aTagMissedAtOneStopAndReadLaterIsNotMissing();
    void everyMarkLooksDifferent();

    void aRangeIsShorterOnThePlanThanInSpace();
    void theExpectedAccuracyIsBestInTheMiddleAndAbsentOnALineOfAnchors();
    void theAccuracyLayerShadesTheFloor();
    void aMeasuredLineTellsLengthDirectionAndParts();
    void thePlantInTheCornerIsThereOnlyWhileTheMapShowsAPart();
    void aPointOfTheCornerPictureIsThePlantPointThere();
    void anAnchorOutsideThePlantIsInTheWholeView();
};

void MapMarksTest::aTrailLeavesOutWhatLiesCloserThanACentimetre()
{
    Trails trails;
    trails.setLimit({});
    for (int i = 0; i < 1000; ++i)
        trails.add(at(0.1 * i, Point2{0.004 * i, 1.0}));
    const Trails::Trail& trail = trails.ofTag(5);
    QVERIFY(trail.size() > 300);
    for (std::size_t i = 1; i < trail.size(); ++i)
        QVERIFY(distance(trail[i - 1].place, trail[i].place) >= Trails::spacing_m);
}

void MapMarksTest::aTrailHoldsNoMoreThanItsMostPoints()
{
    Trails trails;
    trails.setLimit({});
    for (int i = 0; i < 3000; ++i)
        trails.add(at(0.1 * i, Point2{0.02 * i, 1.0}));
    QCOMPARE(trails.ofTag(5).size(), Trails::mostPoints);
    QCOMPARE(trails.ofTag(5).back().place.x, 0.02 * 2999);
}

void MapMarksTest::aTrailForgetsWhatIsOlderThanItsTime()
{
    Trails trails;
    trails.setLimit({10.0, {}});
    for (int i = 0; i <= 100; ++i)
        trails.add(at(i, Point2{0.1 * i, 0.0}));
    QCOMPARE(trails.ofTag(5).size(), std::size_t{11});
    QCOMPARE(trails.ofTag(5).front().place.x, 9.0);
}

void MapMarksTest::aTrailForgetsWhatIsFartherBackThanItsLength()
{
    Trails trails;
    trails.setLimit({{}, 2.0});
    for (int i = 0; i <= 100; ++i)
        trails.add(at(i, Point2{0.125 * i, 0.0}));
    QCOMPARE(trails.ofTag(5).back().place.x - trails.ofTag(5).front().place.x, 2.0);
}

void MapMarksTest::aPoseFoundAnewStartsTheTrailAnew()
{
    Trails trails;
    trails.add(at(0.0, {}, Point2{1.0, 1.0}));
    trails.add(at(0.1, {}, Point2{1.1, 1.0}));
    trails.add(at(0.2, {}, Point2{2.5, 1.0}));
    const Trails::Trail& trail = trails.ofAgv(1);
    QCOMPARE(trail.size(), std::size_t{3});
    QVERIFY(trail[0].startsAnew && !trail[1].startsAnew && trail[2].startsAnew);
}

void MapMarksTest::aDoubtedPoseLeavesNoTrail()
{
    Trails trails;
    trails.add(at(0.0, {}, Point2{1.0, 1.0}));
    PlantSnapshot doubted = at(0.1, {}, Point2{1.1, 1.0});
    doubted.agvs[0].poseHealth = PoseHealth::Doubted;
    trails.add(doubted);
    QCOMPARE(trails.ofAgv(1).size(), std::size_t{1});
}

void MapMarksTest::aTagThatIsNoLongerNamedLosesItsTrail()
{
    Trails trails;
    trails.add(at(0.0, Point2{1.0, 1.0}));
    trails.add(at(0.1, {}));
    QCOMPARE(trails.ofTag(5).size(), std::size_t{1});
    trails.add(PlantSnapshot{});
    QVERIFY(trails.ofTag(5).empty());
}

void MapMarksTest::tagsAreMarkedAsSeenMissingOrUnknown()
{
    const std::vector<FloorTag> tags = scenes::wholePlant().floorTags;
    const TagUid stranger{0x1234};
    model::FloorTagStates marks;
    marks.add(turned({tags[3].uid}, {tags[4].uid}, {stranger}));
    QCOMPARE(marks.stateOf(tags[3].uid), model::FloorTagState::SeenBefore);
    QCOMPARE(marks.stateOf(tags[4].uid), model::FloorTagState::Missing);
    QCOMPARE(marks.stateOf(tags[5].uid), model::FloorTagState::NotSeen);
    QCOMPARE(marks.unknown().size(), std::size_t{1});
    QCOMPARE(marks.unknown()[0].uid, stranger);
    QCOMPARE(marks.unknown()[0].antenna, (Point2{1.0, 1.0}));
    marks.clear();
    QCOMPARE(marks.stateOf(tags[3].uid), model::FloorTagState::NotSeen);
}

void MapMarksTest::aTagMissedAtOneStopAndReadLaterIsNotMissing()
{
    const std::vector<FloorTag> tags = scenes::wholePlant().floorTags;
    model::FloorTagStates marks;
    PlantSnapshot snapshot = turned({}, {tags[4].uid}, {});
    marks.add(snapshot);
    QCOMPARE(marks.stateOf(tags[4].uid), model::FloorTagState::Missing);
    snapshot.agvs[1].recentReads.emplace_back().uid = tags[4].uid;
    marks.add(snapshot);
    QCOMPARE(marks.stateOf(tags[4].uid), model::FloorTagState::SeenNow);
}

void MapMarksTest::everyMarkLooksDifferent()
{
    const std::vector<FloorTag> tags = scenes::wholePlant().floorTags;
    Viewport viewport;
    viewport.setSize({100, 100});
    viewport.setCentre(tags[4].position);
    viewport.setScale(300.0);
    const auto picture = [&](const PlantSnapshot& snapshot) {
        model::FloorTagStates marks;
        marks.add(snapshot);
        QImage image(100, 100, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        paintFloorTagMarks(painter, viewport, marks, {tags[4]}, 0.01, Theme::light());
        return image.convertToFormat(QImage::Format_Mono); // shape, not colour
    };
    const QImage nothing = picture(turned({}, {}, {}));
    const QImage seen = picture(turned({tags[4].uid}, {}, {}));
    const QImage missing = picture(turned({}, {tags[4].uid}, {}));
    QVERIFY(nothing != seen && nothing != missing && seen != missing);
}

void MapMarksTest::aRangeIsShorterOnThePlanThanInSpace()
{
    const UwbAnchor anchor{0, "A0", 0.0, 0.0, 1.5, true};
    QCOMPARE(radiusOnPlan(anchor, 2.5, 0.0), 2.0);
    QCOMPARE(radiusOnPlan(anchor, 1.0, 0.0), 0.0);
}

void MapMarksTest::theExpectedAccuracyIsBestInTheMiddleAndAbsentOnALineOfAnchors()
{
    PlantLayout plant = scenes::uwbPlant();
    const Point2 middle{plant.origin.x + 0.5 * plant.width_m, plant.origin.y + 0.5 * plant.height_m};
    const Point2 corner{plant.origin.x, plant.origin.y};
    QVERIFY(expectedUwbRadius(plant, middle).value() < expectedUwbRadius(plant, corner).value());
    plant.anchors = {{0, "A0", 0, 0, 0.3, true}, {1, "A1", 3, 0, 0.3, true}, {2, "A2", 1, 0, 0.3, true}};
    QVERIFY(!expectedUwbRadius(plant, {2.0, 0.0}));
}

void MapMarksTest::theAccuracyLayerShadesTheFloor()
{
    MapWidget map;
    map.setPlant(scenes::uwbPlant());
    map.resize(900, 700);
    map.show();
    const QImage before = map.grab().toImage();
    MapLayers layers;
    layers.accuracy = true;
    map.setLayers(layers);
    QVERIFY(map.grab().toImage() != before);
    layers.floorTags = layers.stations = false; // their details come first
    map.setLayers(layers);
    const QString details = map.detailsAt(map.viewport().toPixels(Point2{1.5, 1.97}));
    QVERIFY2(details.contains(QStringLiteral("95 % within about")), qPrintable(details));
}

void MapMarksTest::aMeasuredLineTellsLengthDirectionAndParts()
{
    const MeasureLine line{{1.0, 1.0}, {1.3, 0.6}};
    using model::Words;
    QCOMPARE(line.summary(),
             QStringLiteral("%1, %2").arg(Words::millimetres(0.5), Words::degrees(std::atan2(-0.4, 0.3), 1)));
    QVERIFY(line.summary().contains(QStringLiteral("53.1")));
    QCOMPARE(line.parts(),
             QStringLiteral("%1 along x, %2 along y").arg(Words::millimetres(0.3), Words::millimetres(-0.4)));
}

void MapMarksTest::thePlantInTheCornerIsThereOnlyWhileTheMapShowsAPart()
{
    const QRectF area(0.0, 0.0, 3.0, 4.0);
    Viewport viewport;
    viewport.setSize({900, 700});
    viewport.fit(area, {20, 20, 20, 20});
    const Minimap minimap;
    QVERIFY(!minimap.place(viewport, area));
    viewport.zoomAt({450, 350}, 3.0);
    QVERIFY(minimap.place(viewport, area).has_value());
    viewport.setSize({300, 200});
    QVERIFY(!minimap.place(viewport, area)); // it would hide the map
}

void MapMarksTest::aPointOfTheCornerPictureIsThePlantPointThere()
{
    const QRectF area(0.0, 0.0, 4.0, 4.0);
    Viewport viewport;
    viewport.setSize({900, 700});
    viewport.setScale(900.0);
    const Minimap minimap;
    const QRectF place = minimap.place(viewport, area).value();
    const Point2 middle = minimap.plantPointAt(place.center(), viewport, area).value();
    QVERIFY(distance(middle, {2.0, 2.0}) < 0.05);
    const Point2 high = minimap.plantPointAt(place.topLeft() + QPointF(6, 6), viewport, area).value();
    QVERIFY(distance(high, {0.0, 4.0}) < 0.1);
    QVERIFY(!minimap.plantPointAt(place.topLeft() - QPointF(3, 0), viewport, area));
}

void MapMarksTest::anAnchorOutsideThePlantIsInTheWholeView()
{
    PlantLayout plant = scenes::uwbPlant();
    plant.anchors[0].x = plant.origin.x - 1.0;
    QCOMPARE(areaOf(plant).left(), plant.origin.x - 1.0);
    plant.anchors[0].shown = false;
    QVERIFY(areaOf(plant).left() > plant.origin.x - 1.0);
}

QTEST_MAIN(MapMarksTest)
#include "test_map_marks.moc"
