// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trainer.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocalSocket>

#include <cstdio>
#include <iostream>

namespace agv::app {
namespace {

constexpr int answerTimeout_ms = 5000;

int complain(const QString& text)
{
    std::fprintf(stderr, "agv-console trainer: %s\n", qPrintable(text));
    return 1;
}

/// Exit status of one command.
int ask(QLocalSocket& plant, const std::string& command)
{
    plant.write(QByteArray::fromStdString(command) + '\n');
    while (!plant.canReadLine())
        if (!plant.waitForReadyRead(answerTimeout_ms))
            return complain(plant.state() == QLocalSocket::ConnectedState
                                ? QStringLiteral("the simulated plant does not answer")
                                : QStringLiteral("the simulated plant has ended"));
    const QByteArray answer = plant.readLine();
    const QJsonObject message = QJsonDocument::fromJson(answer).object();
    if (message.contains("error"))
        return complain(message["error"].toString());
    if (message.contains("help"))
        for (const QJsonValue line : message["help"].toArray())
            std::printf("%s\n", qPrintable(line.toString()));
    else
        std::fwrite(answer.constData(), 1, static_cast<std::size_t>(answer.size()), stdout);
    std::fflush(stdout);
    return 0;
}

} // namespace

int runTrainer(const TrainerArguments& arguments)
{
    QLocalSocket plant;
    const QString path = QDir::current().absoluteFilePath(QFile::decodeName(arguments.socketPath.c_str()));
    plant.connectToServer(path);
    if (!plant.waitForConnected(answerTimeout_ms))
        return complain("no simulated plant takes commands at " + path);
    if (!arguments.command.empty())
        return ask(plant, arguments.command);
    int status = 0;
    for (std::string line; std::getline(std::cin, line);)
        if (line.find_first_not_of(" \t\r") != std::string::npos && ask(plant, line) != 0)
            status = 1;
    return status;
}

} // namespace agv::app
