// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QObject>
#include <QProcess>
#include <QString>
#include <QTemporaryDir>

#include "app/command_line.h"
#include "core/plant_layout.h"

#include <optional>

namespace agv::app {

/// Where a simulated AGV really stands.
struct TruePose {
    Pose2 pose;
    double charge_percent = 0.0;
};

/// The simulated plant that the console starts beside itself: `agv-console simulate` as a process of its own,
/// steered by lines on its standard input. It ends with this object, and by itself when the console dies,
/// because its standard input ends then.
class SimulatedPlant : public QObject {
    Q_OBJECT
public:
    explicit SimulatedPlant(const PlantChoice& choice, QObject* parent = nullptr);
    ~SimulatedPlant() override;

    void start();
    /// `layout` with the addresses the simulated plant really uses, and free ports for the console.
    PlantLayout adapted(PlantLayout layout) const;
    /// Tells the robots where the console listens.
    void connectConsole(const QString& host, quint16 port, quint16 telemetryPort);
    /// A trainer's command, one line of docs/simulated-plant.md.
    void command(const QByteArray& line);
    /// Asks where the AGVs stand; truthKnown() follows.
    void requestTruth();
    std::optional<TruePose> truth(int robot) const;

signals:
    void ready();
    void truthKnown();
    /// It could not start, or it ended although nobody asked it to.
    void died(const QString& reason);

private:
    void readLines();
    void takeMessage(const QJsonObject& message);
    void onEnd();

    QTemporaryDir m_folder; ///< of the link to the UWB port, whose own path changes at each plugging
    QStringList m_arguments;
    QProcess m_process;
    bool m_ready = false;
    bool m_ending = false;
    QJsonObject m_readyMessage;
    QJsonArray m_truth;
};

} // namespace agv::app
