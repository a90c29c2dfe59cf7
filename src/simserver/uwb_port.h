// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "simulation/uwb_kit.h"

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace agv::simserver {

/// A simulated UWB kit on a real serial device: the unit on the port is the far end of a pseudo-terminal,
/// whose near end a console opens like any serial port. Unplugging ends the pseudo-terminal, as the device
/// node of a USB device ends; plugging makes a new one, perhaps with another path. Bytes that nobody reads
/// are lost. Runs when it is called; no timer, no thread.
class UwbPort {
public:
    /// Plugged in from the beginning. `link`: a symbolic link that leads to the device while it is plugged
    /// in; one that is there already is replaced. Io: no pseudo-terminal, or the link cannot be made. InUse:
    /// `link` is no symbolic link.
    static Result<std::unique_ptr<UwbPort>> create(simulation::UwbKitSettings settings,
                                                   std::optional<std::string> link, Time start);
    ~UwbPort();
    UwbPort(const UwbPort&) = delete;
    UwbPort& operator=(const UwbPort&) = delete;

    /// Lets the kit run up to `now` with the tags at these places, and passes bytes both ways; call it every
    /// few ms.
    void advance(Time now, std::span<const simulation::UwbTagPlace> tags);

    /// Takes the unit off its port, for `away` or until plug().
    void unplug(std::optional<Duration> away, Time now);
    Result<void> plug(Time now);
    bool isPlugged() const { return m_master >= 0; }
    /// Of the device; empty while unplugged.
    const std::string& path() const { return m_path; }

    simulation::UwbKit& kit() { return m_kit; }

private:
    UwbPort(simulation::UwbKitSettings settings, std::optional<std::string> link, Time start);
    Result<void> openTerminal();
    void closeTerminal();
    bool isOpenedBySomebody() const;
    void readCommands(Time now);

    simulation::UwbKit m_kit;
    std::optional<std::string> m_link;
    int m_master = -1;
    std::string m_path;
    std::optional<Time> m_backAt; ///< while unplugged for a time
};

} // namespace agv::simserver
