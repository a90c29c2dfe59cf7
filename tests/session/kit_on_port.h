// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>

#include "core/plant_layout.h"
#include "session/uwb_link.h"
#include "simserver/uwb_port.h"

#include <memory>
#include <vector>

namespace agv::session {

inline PlantLayout plantWithUwb()
{
    PlantLayout plant;
    plant.name = "test";
    plant.width_m = 3.0;
    plant.height_m = 4.0;
    plant.anchors = {{0, "A0", 0.0, 0.0, 2.0, true},
                     {1, "A1", 3.0, 0.0, 2.0, true},
                     {2, "A2", 3.0, 4.0, 2.0, true},
                     {3, "A3", 0.0, 4.0, 2.5, true}};
    return plant;
}

/// A simulated kit on a pseudo-terminal. Its time is virtual: it runs as fast as it is asked to.
class KitOnPort {
public:
    KitOnPort(simulation::UwbKitSettings settings, std::vector<simulation::UwbTagPlace> places)
        : tags(std::move(places))
    {
        auto made = simserver::UwbPort::create(std::move(settings), std::nullopt, m_now);
        if (made)
            port = std::move(*made);
    }

    /// Lets the kit run for `time` of its own.
    void run(Duration time)
    {
        m_now += time;
        port->advance(m_now, tags);
    }
    /// Lets the kit and this program run until `isTrue`; false when that takes half a minute.
    template<typename Condition>
    bool runUntil(Condition isTrue)
    {
        QElapsedTimer patience;
        patience.start();
        while (!isTrue()) {
            if (patience.hasExpired(30'000))
                return false;
            run(std::chrono::milliseconds(20));
            QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
        }
        return true;
    }
    void unplug() { port->unplug({}, m_now); }
    bool plug() { return port->plug(m_now).has_value(); }
    /// As the system lists the unit: a TREK1000 unit with a serial number, wherever it is plugged in.
    std::vector<link::SerialPortEntry> listed() const
    {
        if (!port->isPlugged())
            return {};
        return {{QString::fromStdString(port->path()), QStringLiteral("STM32 Virtual COM Port"), usb,
                 QStringLiteral("3061")}};
    }
    /// Tries again at once, and finds the unit in listed().
    UwbLinkParameters parameters() const
    {
        UwbLinkParameters parameters;
        parameters.life.backOff = {std::chrono::milliseconds(1)};
        parameters.ports = [this] { return listed(); };
        return parameters;
    }

    std::vector<simulation::UwbTagPlace> tags;
    std::unique_ptr<simserver::UwbPort> port;
    UsbId usb = trekUsbId;

private:
    Time m_now;
};

} // namespace agv::session
