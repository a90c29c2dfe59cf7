// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/plant_layout.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace agv::gui {
class MainWindow;
}
namespace agv::session {
class Session;
}

namespace agv::app {

/// What the window asks for its UWB screens: files are read and written here, the rest goes to the session.
/// Lives in the GUI thread; window and session outlive it.
class UwbRequests : public QObject {
public:
    /// `plantFile`: where edits are saved. Without one they hold for this session, and the window says so.
    UwbRequests(gui::MainWindow& window, session::Session& session, PlantLayout plant,
                std::optional<std::filesystem::path> plantFile);

private:
    void connectSession(session::Session& session);
    void keepEdits(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings);
    void importFile(const QString& path);
    void exportFile(const QString& path, const std::vector<UwbAnchor>& anchors, const UwbSettings& settings);
    void save(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings);

    gui::MainWindow& m_window;
    PlantLayout m_plant; ///< as it is edited
    std::optional<std::filesystem::path> m_plantFile;
};

} // namespace agv::app
