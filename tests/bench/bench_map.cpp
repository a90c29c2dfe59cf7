// SPDX-License-Identifier: GPL-3.0-or-later
// Milliseconds per frame of the map at 1920 x 1080: the whole plant, a snapshot per frame.
#include "gui/map/map_widget.h"
#include "gui/scenes.h"

#include <QApplication>
#include <QImage>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <vector>

namespace {

void report(const char* name, int frames, const std::function<void(int)>& frame)
{
    std::vector<double> times_ms;
    for (int i = 0; i < frames; ++i) {
        const auto start = std::chrono::steady_clock::now();
        frame(i);
        times_ms.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::sort(times_ms.begin(), times_ms.end());
    const auto at = [&](double part) {
        return times_ms[static_cast<std::size_t>(part * static_cast<double>(times_ms.size() - 1))];
    };
    std::printf("%-44s median %6.2f ms   p99 %6.2f ms   (%d frames)\n", name, at(0.5), at(0.99), frames);
}

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    agv::gui::MapWidget map;
    map.setPlant(agv::scenes::wholePlant());
    map.resize(1920, 1080);
    map.show();
    QImage screen(map.size(), QImage::Format_RGB32);
    const agv::PlantSnapshot snapshots[] = {agv::scenes::finished(), agv::scenes::turning(),
                                            agv::scenes::ambiguous()};
    report("snapshot, view unchanged", 600, [&](int i) {
        map.showSnapshot(snapshots[i % 3]);
        map.render(&screen);
    });
    report("zoom or pan, static layer painted anew", 200, [&](int i) {
        i % 2 == 0 ? map.zoomIn() : map.zoomOut();
        map.render(&screen);
    });
    map.setSelectedRobot(1);
    map.zoomToSelected();
    report("snapshot, one AGV large", 600, [&](int i) {
        map.showSnapshot(snapshots[i % 3]);
        map.render(&screen);
    });
    return 0;
}
