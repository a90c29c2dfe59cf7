// SPDX-License-Identifier: GPL-3.0-or-later
// gui_gallery FOLDER [light|dark] [WIDTHxHEIGHT] [LOCALE] [SCENE]: pictures of the window, to be looked at.
#include "gui/application_setup.h"
#include "gui/main_window.h"
#include "gui/scenes.h"
#include "gui/theme.h"
#include "gui/uwb_gallery.h"

#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QSettings>
#include <QTabWidget>

using namespace agv;

namespace {

struct Scene {
    const char* name;
    PlantSnapshot snapshot;
    bool zoomed;
};

std::vector<Scene> allScenes()
{
    return {{"1-idle", scenes::idle(), false},
            {"2-links-up", scenes::linksUp(), false},
            {"3-turning", scenes::turning(), false},
            {"4-finished", scenes::finished(), false},
            {"5-finished-zoom", scenes::finished(), true},
            {"6-ambiguous", scenes::ambiguous(), true},
            {"7-link-lost", scenes::linkLost(), false},
            {"8-turning-zoom", scenes::turning(), true}};
}

void addEvents(gui::MainWindow& window)
{
    const qint64 now = 1773761405123;
    window.addEvent({now, EventLevel::Info, "Console", "Listening for robots on 127.0.0.1:2001"});
    window.addEvent({now + 840, EventLevel::Info, "Robot 1", "Connected from 192.168.1.201"});
    window.addEvent(
        {now + 2210, EventLevel::Warning, "RFID reader 2", "Silent for 5 s; trying again in 1 s"});
    window.addEvent({now + 9105, EventLevel::Error, "RFID reader 4", "Address not known: wemos4.local"});
    window.addEvent({now + 12400, EventLevel::Info, "AGV 1", "Turn finished: 1204 mm, 873 mm, 92.3 degrees"});
}

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    const QString folder = arguments.value(1, QStringLiteral("gallery"));
    const bool dark = arguments.value(2) == QLatin1String("dark");
    const QStringList size = arguments.value(3, QStringLiteral("1280x800")).split(QLatin1Char('x'));
    const QLocale locale(arguments.value(4, QStringLiteral("en_GB")));
    gui::setUpApplication(application, locale);
    QApplication::setOrganizationName(QStringLiteral("agv-console-gallery"));
    QSettings().clear();
    QApplication::setPalette((dark ? gui::Theme::darkTheme() : gui::Theme::light()).toPalette());
    QDir().mkpath(folder);
    for (const Scene& scene : allScenes()) {
        if (arguments.size() > 5 && !QString::fromLatin1(scene.name).contains(arguments[5]))
            continue;
        QSettings().clear();
        gui::MainWindow window(scenes::wholePlant());
        window.resize(size.value(0).toInt(), size.value(1).toInt());
        window.show();
        if (scene.snapshot.agvs.front().robotLink.state != LinkState::Down)
            addEvents(window);
        window.showSnapshot(scene.snapshot);
        QApplication::processEvents();
        if (scene.zoomed) {
            window.findChild<QAction*>(QStringLiteral("zoomToAction"))->trigger();
            window.findChild<QTabWidget*>(QStringLiteral("tabs"))->setCurrentIndex(1);
        }
        for (int i = 0; i < 5; ++i)
            QApplication::processEvents();
        const QString file =
            QStringLiteral("%1/%2-%3-%4-%5.png")
                .arg(folder, QString::fromLatin1(scene.name),
                     dark ? QStringLiteral("dark") : QStringLiteral("light"), size.value(0), locale.name());
        window.grab().save(file);
    }
    if (arguments.size() <= 5 || arguments[5] == QLatin1String("uwb")) {
        const QString suffix =
            QStringLiteral("%1-%2-%3")
                .arg(dark ? QStringLiteral("dark") : QStringLiteral("light"), size.value(0), locale.name());
        saveUwbPictures(folder, suffix, QSize(size.value(0).toInt(), size.value(1).toInt()));
    }
    return 0;
}
