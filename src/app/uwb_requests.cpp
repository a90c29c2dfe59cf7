// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/uwb_requests.h"

#include "app/uwb_kit_files.h"
#include "gui/main_window.h"
#include "link/serial_port_list.h"
#include "session/session.h"

#include <QFile>

#include <utility>

namespace agv::app {
namespace {

std::filesystem::path fsPath(const QString& path) { return QFile::encodeName(path).toStdString(); }

std::vector<SerialPortInfo> portsOfThisComputer()
{
    std::vector<SerialPortInfo> ports;
    for (const link::SerialPortEntry& port : link::availableSerialPorts())
        ports.push_back({port.path.toStdString(), port.description.toStdString(), port.usb,
                         port.serialNumber.toStdString()});
    return ports;
}

} // namespace

UwbRequests::UwbRequests(gui::MainWindow& window, session::Session& session, PlantLayout plant,
                         std::optional<std::filesystem::path> plantFile)
    : m_window(window),
      m_plant(std::move(plant)),
      m_plantFile(std::move(plantFile))
{
    using gui::MainWindow;
    m_window.setUwbSavable(m_plantFile.has_value());
    connect(&m_window, &MainWindow::uwbEdited, this, &UwbRequests::keepEdits);
    connect(&m_window, &MainWindow::importUwbRequested, this, &UwbRequests::importFile);
    connect(&m_window, &MainWindow::exportUwbRequested, this, &UwbRequests::exportFile);
    connect(&m_window, &MainWindow::saveUwbRequested, this, &UwbRequests::save);
    connect(&m_window, &MainWindow::serialPortsRequested, this,
            [this] { m_window.showSerialPorts(portsOfThisComputer()); });
    connectSession(session);
}

void UwbRequests::connectSession(session::Session& session)
{
    using gui::MainWindow;
    using session::Session;
    // Another port comes with the edit, too: one connection, or it would be opened twice.
    connect(&m_window, &MainWindow::uwbEdited, &session, &Session::setUwb);
    connect(&m_window, &MainWindow::openUwbRequested, &session, &Session::openUwb);
    connect(&m_window, &MainWindow::closeUwbRequested, &session, &Session::closeUwb);
    connect(&m_window, &MainWindow::askUwbRequested, &session, &Session::askUwb);
    connect(&m_window, &MainWindow::surveyAnchorsRequested, &session, &Session::surveyAnchors);
    connect(&session, &Session::anchorsSurveyed, &m_window, &MainWindow::showAnchorSurvey);
    connect(&m_window, &MainWindow::startRangeCalibrationRequested, &session,
            &Session::startRangeCalibration);
    connect(&m_window, &MainWindow::cancelRangeCalibrationRequested, &session,
            &Session::cancelRangeCalibration);
}

void UwbRequests::keepEdits(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings)
{
    m_plant.anchors = anchors;
    m_plant.uwb = settings;
}

void UwbRequests::importFile(const QString& path)
{
    const Result<ImportedUwb> imported = importUwb(fsPath(path), m_plant);
    if (!imported)
        return m_window.showUwbNote(EventLevel::Error, QString::fromStdString(imported.error().detail));
    QStringList notes;
    for (const std::string& note : imported->notes)
        notes << QString::fromStdString(note);
    m_window.takeImportedUwb(imported->anchors, imported->settings, notes);
}

void UwbRequests::exportFile(const QString& path, const std::vector<UwbAnchor>& anchors,
                             const UwbSettings& settings)
{
    const Result<std::string> written = exportUwb(fsPath(path), anchors, settings);
    m_window.showUwbNote(written ? EventLevel::Info : EventLevel::Error,
                         QString::fromStdString(written ? *written : written.error().detail));
}

void UwbRequests::save(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings)
{
    if (!m_plantFile)
        return m_window.showUwbSaved(false, QStringLiteral("Not saved: there is no plant file"));
    const Result<void> saved = saveUwb(*m_plantFile, anchors, settings);
    m_window.showUwbSaved(
        saved.has_value(),
        saved ? QStringLiteral("Saved to %1").arg(QString::fromStdString(m_plantFile->string()))
              : QStringLiteral("Not saved: %1").arg(QString::fromStdString(saved.error().detail)));
}

} // namespace agv::app
