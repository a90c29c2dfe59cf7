// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulated_plant.h"

#include "core/units.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>

#include <unistd.h>

namespace agv::app {
namespace {

constexpr int endTimeout_ms = 2000;

QStringList argumentsFor(const PlantChoice& choice)
{
    QStringList arguments{"simulate", "--parent-guard", "--seed", QString::number(choice.seed)};
    if (choice.plantFile)
        arguments << "--plant" << QString::fromStdString(*choice.plantFile);
    if (choice.smallField)
        arguments << "--small-field";
    if (choice.batteryPercent)
        arguments << "--battery" << QString::number(*choice.batteryPercent, 'g', 12);
    if (choice.controlSocket)
        arguments << "--control" << QFile::decodeName(choice.controlSocket->c_str());
    return arguments;
}

QJsonObject entryOf(const QJsonArray& entries, int robot)
{
    for (const QJsonValue& entry : entries) {
        if (entry["robot"].toInt() == robot)
            return entry.toObject();
    }
    return {};
}

} // namespace

SimulatedPlant::SimulatedPlant(const PlantChoice& choice, QObject* parent)
    : QObject(parent),
      m_arguments(argumentsFor(choice))
{
    if (m_folder.isValid())
        m_arguments << "--uwb-link" << m_folder.filePath("uwb");
    m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    // A process group of its own: Ctrl-C is for the console, which stops the robots before it ends them.
    m_process.setChildProcessModifier([] { ::setpgid(0, 0); });
    connect(&m_process, &QProcess::readyReadStandardOutput, this, &SimulatedPlant::readLines);
    connect(&m_process, &QProcess::finished, this, &SimulatedPlant::onEnd);
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            onEnd();
    });
}

SimulatedPlant::~SimulatedPlant()
{
    m_ending = true;
    if (m_process.state() == QProcess::NotRunning)
        return;
    m_process.closeWriteChannel();
    if (!m_process.waitForFinished(endTimeout_ms)) {
        m_process.kill();
        m_process.waitForFinished(endTimeout_ms);
    }
}

void SimulatedPlant::start() { m_process.start(QCoreApplication::applicationFilePath(), m_arguments); }

PlantLayout SimulatedPlant::adapted(PlantLayout layout) const
{
    const QJsonArray readers = m_readyMessage["readers"].toArray();
    const QJsonArray robots = m_readyMessage["robots"].toArray();
    for (AgvConfig& agv : layout.agvs) {
        const QJsonObject reader = entryOf(readers, agv.id.number);
        agv.reader = {reader["host"].toString().toStdString(),
                      static_cast<std::uint16_t>(reader["port"].toInt())};
        agv.robotHost = entryOf(robots, agv.id.number)["host"].toString().toStdString();
    }
    const QJsonObject uwb = m_readyMessage["uwb"].toObject();
    const QString uwbPort = uwb.contains("link") ? uwb["link"].toString() : uwb["path"].toString();
    layout.uwb.port = {uwbPort.toStdString(), trekUsbId, {}};
    layout.robotListen = {"127.0.0.1", 0};
    layout.telemetryPort = 0;
    return layout;
}

void SimulatedPlant::connectConsole(const QString& host, quint16 port, quint16 telemetryPort)
{
    command(QStringLiteral("console %1 %2 %3").arg(host).arg(port).arg(telemetryPort).toUtf8());
}

void SimulatedPlant::requestTruth() { command("truth"); }

std::optional<TruePose> SimulatedPlant::truth(int robot) const
{
    const QJsonObject entry = entryOf(m_truth, robot);
    if (entry.isEmpty())
        return std::nullopt;
    return TruePose{{{metresFromMm(entry["x_mm"].toDouble()), metresFromMm(entry["y_mm"].toDouble())},
                     wrapAngle(radFromDeg(entry["heading_deg"].toDouble()))},
                    entry["charge_percent"].toDouble()};
}

void SimulatedPlant::command(const QByteArray& line) { m_process.write(line + '\n'); }

void SimulatedPlant::readLines()
{
    while (m_process.canReadLine()) {
        const QJsonDocument document = QJsonDocument::fromJson(m_process.readLine());
        if (document.isObject())
            takeMessage(document.object());
    }
}

void SimulatedPlant::takeMessage(const QJsonObject& message)
{
    if (message["ready"].toBool() && !m_ready) {
        m_ready = true;
        m_readyMessage = message;
        emit ready();
    } else if (message["truth"].isArray()) {
        m_truth = message["truth"].toArray();
        emit truthKnown();
    }
}

void SimulatedPlant::onEnd()
{
    if (m_ending)
        return;
    m_ending = true;
    if (m_process.error() == QProcess::FailedToStart)
        emit died(
            QStringLiteral("The simulated plant could not be started: %1").arg(m_process.errorString()));
    else if (m_process.exitStatus() == QProcess::CrashExit) // the code is then the signal's number
        emit died(QStringLiteral("The simulated plant was ended by signal %1").arg(m_process.exitCode()));
    else
        emit died(QStringLiteral("The simulated plant ended unexpectedly (exit status %1)")
                      .arg(m_process.exitCode()));
}

} // namespace agv::app
