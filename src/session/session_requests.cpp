// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_private.h"

#include "estimation/uwb/anchor_survey.h"

#include <cmath>
#include <utility>

namespace agv::session {
namespace {

std::string inMilli(double value, const char* unit)
{
    return std::to_string(std::lround(value * 1e3)) + " " + unit;
}

std::string textOf(const TurnParameters& parameters)
{
    return std::string(parameters.kind == TurnKind::Measured ? "measured" : "timed") + ", " +
           std::to_string(parameters.stopsPerTurn) + " stops, " + inMilli(parameters.turnTime_s, "ms") +
           ", " + inMilli(parameters.wheelSpeed_m_s, "mm/s") + ", " + toText(parameters.rotation);
}

} // namespace

void Session::openReader(int robot)
{
    d->tee->action("open reader", robot);
    if (AgvLine* line = d->line(robot))
        line->openReader();
}

void Session::closeReader(int robot)
{
    d->tee->action("close reader", robot);
    if (AgvLine* line = d->line(robot))
        line->closeReader();
}

void Session::setReaderEndpoint(int robot, const QString& host, quint16 port)
{
    d->tee->action("set reader address", robot, toText(Endpoint{host.toStdString(), port}));
    if (AgvLine* line = d->line(robot))
        line->setReaderEndpoint({host.toStdString(), port});
}

void Session::openUwb()
{
    d->tee->action("open uwb");
    d->isUwbWanted = true;
    if (d->uwb)
        d->uwb->link().open();
}

void Session::closeUwb()
{
    d->tee->action("close uwb");
    d->isUwbWanted = false;
    if (d->uwb)
        d->uwb->link().close();
}

void Session::setUwbPort(const SerialPortChoice& port)
{
    d->tee->action("set uwb port", {}, toText(port));
    if (d->uwb)
        d->uwb->link().setPort(port);
}

void Session::surveyAnchors()
{
    emit anchorsSurveyed(d->uwb ? d->uwb->link().surveyAnchors(monotonicNow())
                                : estimation::surveyAnchors({}, {}));
}

void Session::askUwb()
{
    if (d->uwb)
        d->uwb->link().ask();
}

void Session::setUwb(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings)
{
    d->tee->action("edit uwb", {}, std::to_string(anchors.size()) + " anchors");
    d->plant.anchors = anchors;
    d->plant.uwb = settings;
    d->recorder->setPlant(d->plant);
    d->changed = true;
    if (anchors.empty()) {
        delete std::exchange(d->uwb, nullptr);
    } else if (d->uwb) {
        d->uwb->link().setLayout(anchors, settings);
    } else {
        d->addUwb();
        if (d->isUwbWanted)
            d->uwb->link().open();
    }
}

void Session::startRangeCalibration(int tag, double x, double y, double z, double seconds)
{
    d->tee->action("calibrate ranges", {}, "tag " + std::to_string(tag));
    if (d->uwb)
        d->uwb->link().startRangeCalibration(tag, {x, y, z}, seconds);
    d->changed = true;
}

void Session::cancelRangeCalibration()
{
    d->tee->action("cancel range calibration");
    if (d->uwb)
        d->uwb->link().cancelRangeCalibration();
    d->changed = true;
}

void Session::startTurn(int robot, const TurnParameters& parameters)
{
    AgvLine* line = d->line(robot);
    if (!line)
        return;
    d->tee->beginTurn();
    d->tee->action("start turn", robot, textOf(parameters));
    line->startTurn(parameters);
}

void Session::abortTurn(int robot, const QString& reason)
{
    d->tee->action("abort turn", robot, reason.toStdString());
    if (AgvLine* line = d->line(robot))
        line->abortTurn(reason.toStdString());
}

void Session::retakeStop(int robot, int stop)
{
    d->tee->action("read stop again", robot, "stop " + std::to_string(stop + 1));
    if (AgvLine* line = d->line(robot))
        line->retakeStop(stop);
}

void Session::setTurnTime(int robot, double seconds)
{
    d->tee->action("set sleeptime", robot, inMilli(seconds, "ms"));
    if (AgvLine* line = d->line(robot))
        line->setTurnTime(seconds);
}

void Session::setTurnSpeed(int robot, double metresPerSecond)
{
    d->tee->action("set wheel speed", robot, inMilli(metresPerSecond, "mm/s"));
    if (AgvLine* line = d->line(robot))
        line->setTurnSpeed(metresPerSecond);
}

void Session::warn(const QString& text) { d->log(EventLevel::Warning, text.toStdString()); }

void Session::stopAll(const QString& reason)
{
    d->tee->action("stop all", {}, reason.toStdString());
    d->log(EventLevel::Warning, "All AGVs were told to stop: " + reason.toStdString());
    for (const auto& [robot, line] : d->lines)
        line->stopAll(reason.toStdString());
}

void Session::startRun(const QString& note) { d->recorder->start("operator", note.toStdString()); }

void Session::stopRun() { d->recorder->stop(); }

void Session::keepRecent() { d->recorder->keepRecent(); }

} // namespace agv::session
