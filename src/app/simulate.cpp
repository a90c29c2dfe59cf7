// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulate.h"

#include <QCoreApplication>
#include <QFile>

#include "core/plant_file.h"
#include "simserver/control_channel.h"
#include "simserver/control_socket.h"
#include "simserver/plant_server.h"
#include "simserver/truth_log.h"

#include <QJsonDocument>

#include <cstdio>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

namespace agv::app {
namespace {

int complain(const Error& error)
{
    std::fprintf(stderr, "agv-console simulate: %s\n", error.detail.c_str());
    return 1;
}

void printLine(const QByteArray& line)
{
    std::fwrite(line.data(), 1, static_cast<std::size_t>(line.size()), stdout);
    std::fputc('\n', stdout);
    std::fflush(stdout);
}

Result<PlantLayout> builtInPlant(const QString& name)
{
    QFile file(":/" + name);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::NotFound, "this program was built without its example plant " +
                                                name.toStdString() + "; name a plant file with --plant");
    const auto document = PlantDocument::fromText(file.readAll().toStdString(), name.toStdString());
    if (!document)
        return std::unexpected(document.error());
    return document->layout();
}

Result<PlantLayout> plantOf(const SimulateArguments& arguments)
{
    if (arguments.plantFile)
        return readPlantFile(*arguments.plantFile);
    return builtInPlant(arguments.smallField ? QStringLiteral("small-field.json")
                                             : QStringLiteral("plant.json"));
}

bool isPipe(int descriptor)
{
    struct stat status{};
    return ::fstat(descriptor, &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
}

int writeEmulator(const SimulateArguments& arguments)
{
    const auto paths = simulation::writeEmulatorFiles(*arguments.emulatorFolder, arguments.emulator);
    if (!paths)
        return complain(paths.error());
    std::printf("%s\n%s\n", paths->readings.c_str(), paths->side.c_str());
    return 0;
}

Result<simulation::Plant> makePlant(const SimulateArguments& arguments)
{
    auto layout = plantOf(arguments);
    if (!layout)
        return std::unexpected(layout.error());
    simulation::PlantSettings settings;
    settings.seed = arguments.seed;
    if (arguments.batteryPercent)
        settings.charge = *arguments.batteryPercent / 100.0;
    return simulation::Plant::create(std::move(*layout), settings);
}

int serve(const SimulateArguments& arguments)
{
    auto plant = makePlant(arguments);
    if (!plant)
        return complain(plant.error());
    simserver::PlantServer server(std::move(*plant), {.seed = arguments.seed,
                                                      .fixedReaderPorts = arguments.fixedReaderPorts,
                                                      .console = arguments.console,
                                                      .telemetryPort = arguments.telemetryPort,
                                                      .uwbLink = arguments.uwbLink,
                                                      .uwbDialect = arguments.uwbDialect,
                                                      .uwbFast = !arguments.uwbSlow});
    std::optional<simserver::TruthLog> truthLog;
    if (arguments.truthLog) {
        auto opened = simserver::TruthLog::open(*arguments.truthLog);
        if (!opened)
            return complain(opened.error());
        truthLog.emplace(std::move(*opened));
        QObject::connect(&server, &simserver::PlantServer::ticked, &server,
                         [&] { truthLog->record(server.plant()); });
    }
    if (auto started = server.start(); !started)
        return complain(started.error());

    simserver::ControlSocket socket(server);
    if (arguments.controlSocket) {
        if (auto listening = socket.listen(QFile::decodeName(arguments.controlSocket->c_str())); !listening)
            return complain(listening.error());
    }
    simserver::ControlChannel control(server, STDIN_FILENO);
    QObject::connect(&control, &simserver::ControlChannel::line, &control, printLine);
    // Queued: the answer to the last command goes out first.
    const auto quit = [] { QCoreApplication::quit(); };
    QObject::connect(&server, &simserver::PlantServer::quitRequested, &control, quit, Qt::QueuedConnection);
    if (arguments.parentGuard || isPipe(STDIN_FILENO))
        QObject::connect(&control, &simserver::ControlChannel::inputEnded, &control, quit,
                         Qt::QueuedConnection);
    printLine(QJsonDocument(server.readyMessage()).toJson(QJsonDocument::Compact));
    return QCoreApplication::exec();
}

} // namespace

int runSimulate(const SimulateArguments& arguments)
{
    if (arguments.emulatorFolder)
        return writeEmulator(arguments);
    if (QCoreApplication::instance())
        return serve(arguments);
    int count = 1;
    char name[] = "agv-console";
    char* names[] = {name, nullptr};
    const QCoreApplication application(count, names);
    return serve(arguments);
}

} // namespace agv::app
