// SPDX-License-Identifier: GPL-3.0-or-later
// Milliseconds per frame of the map at 1920 x 1080, a snapshot per frame: the plant, and a hall with 10,000
// floor tags and 1,000 UWB tags that move, with trails of 100 points.
#include "bench/frame_times.h"
#include "gui/map/map_widget.h"
#include "gui/scenes.h"

#include <QApplication>
#include <QImage>

#include <cmath>

namespace {

using agv::bench::reportFrames;

agv::PlantLayout hall()
{
    agv::PlantLayout plant = agv::scenes::wholePlant();
    plant.width_m = 20.0;
    plant.height_m = 10.0;
    plant.floorTags = agv::tagGrid(125, 80, 0.12, {1.0, 0.2}, agv::TagUid{0x1000});
    return plant;
}

/// A tag goes round a circle of its own, 5 mm a frame; at frame 100 its trail has 100 points.
void moveTags(agv::PlantSnapshot& snapshot, int frame)
{
    snapshot.time += std::chrono::milliseconds(16);
    for (agv::UwbTagSnapshot& tag : snapshot.uwb->tags) {
        const double angle = 0.02 * frame + tag.id;
        tag.position = agv::Point2{1.0 + 0.018 * tag.id + 0.5 * std::cos(angle),
                                   5.0 + 4.0 * std::sin(1.7 * tag.id) + 0.5 * std::sin(angle)};
    }
}

agv::PlantSnapshot movingTags(int count)
{
    agv::PlantSnapshot snapshot = agv::scenes::finished();
    snapshot.uwb = agv::UwbSnapshot{};
    for (int id = 0; id < count; ++id) {
        agv::UwbTagSnapshot& tag = snapshot.uwb->tags.emplace_back();
        tag.id = id;
        tag.covariance = {4e-4, 0.0, 2e-4};
    }
    return snapshot;
}

void reportMoving(agv::gui::MapWidget& map, QImage& screen, const char* name, int tags)
{
    agv::PlantSnapshot snapshot = movingTags(tags);
    int frame = 0;
    for (; frame < 110; ++frame) {
        moveTags(snapshot, frame);
        map.showSnapshot(snapshot);
    }
    reportFrames(name, 300, [&](int) {
        moveTags(snapshot, ++frame);
        map.showSnapshot(snapshot);
        map.render(&screen);
    });
}

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    agv::gui::MapWidget map;
    map.setPlant(agv::scenes::wholePlant());
    map.resize(1920, 1080);
    map.show();
    QImage screen(map.size(), QImage::Format_RGB32);
    const agv::PlantSnapshot snapshots[] = {agv::scenes::finished(), agv::scenes::turning(),
                                            agv::scenes::ambiguous()};
    reportFrames("plant: snapshot, view unchanged", 600, [&](int i) {
        map.showSnapshot(snapshots[i % 3]);
        map.render(&screen);
    });
    reportMoving(map, screen, "plant: 8 UWB tags moving with trails", 8);
    reportFrames("plant: zoom or pan, static layer painted anew", 200, [&](int i) {
        i % 2 == 0 ? map.zoomIn() : map.zoomOut();
        map.render(&screen);
    });
    map.setSelectedRobot(1);
    map.zoomToSelected();
    reportFrames("plant: snapshot, one AGV large", 600, [&](int i) {
        map.showSnapshot(snapshots[i % 3]);
        map.render(&screen);
    });
    map.setPlant(hall());
    map.setTrailLimit({100 * 0.016, std::nullopt});
    reportMoving(map, screen, "hall: 10,000 floor tags, 1,000 tags moving with trails", 1000);
    map.setPlant(hall()); // without the trails of before
    agv::gui::MapLayers plain;
    plain.uncertainty = false;
    map.setLayers(plain);
    reportMoving(map, screen, "  the same without ellipses", 1000);
    return 0;
}
