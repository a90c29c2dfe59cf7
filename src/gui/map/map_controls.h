// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "gui/map/map_widget.h"

class QAction;

namespace Ui {
class MainWindow;
}

namespace agv::gui {

/// The menu *Map* of the window: view, layers, trails, tools, pictures, and the menu under the pointer. What
/// is shown is kept from session to session. GUI thread.
class MapControls : public QObject {
    Q_OBJECT
public:
    MapControls(Ui::MainWindow& ui, QWidget* window);

signals:
    /// A sentence for the event log; in the language of the program.
    void pictureSaved(bool saved, const QString& sentence);

private:
    void connectView();
    void connectLayers();
    void connectTrails();
    void connectTools();
    void connectPictures();
    void updateLayers();
    void showMenu(QPoint position, Point2 place);
    void copyPicture();
    void askForPicture();
    void savePictureAs(const QString& path);

    Ui::MainWindow& m_ui;
    QWidget* m_window;
    MapWidget* m_map;
};

} // namespace agv::gui
