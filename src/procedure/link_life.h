// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/snapshot.h"
#include "core/units.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace agv::procedure {

/// What to look for, by the kind of device; the ends of sentences. Those here are of an RFID reader.
struct LinkHints {
    std::string noAnswer = "check the address and that the device has power and Wi-Fi";
    std::string silent = "no floor tag below the antenna, or the link is dead";
    std::string stillSilent = "no floor tag below the antenna, or the reader has no power";
};

struct LinkLifeParameters {
    Duration connectTimeout = std::chrono::seconds(3);
    Duration silentAfter = std::chrono::seconds(2);       ///< Up -> Silent without data
    Duration lostAfter = std::chrono::milliseconds(4500); ///< Silent -> remade, counted from the last data
    /// The same for a connection that was remade and is silent still. A fresh one is hardly half-open; more
    /// likely no tag lies below the antenna, and each remaking would miss the first reads after that.
    Duration muteLostAfter = std::chrono::seconds(20);
    /// Between tries, rising; the last one goes on. Not empty.
    std::vector<Duration> backOff{std::chrono::milliseconds(500), std::chrono::seconds(1),
                                  std::chrono::seconds(2), std::chrono::seconds(5)};
    LinkHints hints = {};
};

/// What the caller must do with the transport.
enum class LinkAction { None, Open, Close };

/// Life of a client connection as a pure state machine:
/// | state              | event                       | next    | action |
/// |--------------------|-----------------------------|---------|--------|
/// | Down, Failed, Waiting | open()                   | Opening | Open   |
/// | Opening            | connected                   | Up      |        |
/// | Opening            | connected, was mute before  | Silent  |        |
/// | Opening            | connect time-out            | Waiting | Close  |
/// | Opening, Up, Silent| transient failure           | Waiting | Close  |
/// | Opening, Up, Silent| persistent failure          | Failed  | Close  |
/// | Up                 | no data for silentAfter     | Silent  |        |
/// | Up, Silent         | data                        | Up      |        |
/// | Silent             | no data for lostAfter (muteLostAfter if mute before) | Waiting | Close |
/// | Waiting            | back-off over (0.5, 1, 2, 5, 5, ... s) | Opening | Open |
/// | any                | close()                     | Down    | Close  |
/// Everything else is ignored. Data and silence reset the back-off. "Mute before" means that the connection
/// was closed for its silence: until data arrives the new one counts as Silent, not as Up.
class LinkLife {
public:
    explicit LinkLife(LinkLifeParameters parameters = {}) : m_parameters(std::move(parameters)) {}

    LinkAction open(Time now);
    LinkAction close();
    LinkAction connected(Time now);
    LinkAction data(Time now);
    LinkAction failed(bool transient, std::string reason, Time now);
    LinkAction onTimer(Time now);

    std::optional<Time> deadline() const { return m_deadline; }
    LinkState state() const { return m_state; }
    bool isConnected() const { return m_state == LinkState::Up || m_state == LinkState::Silent; }
    /// The connection stands or is being remade only because nothing was heard: an idle reader looks like
    /// that.
    bool isMute() const { return m_mute; }
    const std::string& reason() const { return m_reason; }
    std::optional<Time> lastData() const { return m_lastData; }
    std::optional<Time> retryAt() const;

private:
    LinkAction wait(std::string reason, Time now);
    LinkAction beginOpening(Time now);

    LinkLifeParameters m_parameters;
    LinkState m_state = LinkState::Down;
    std::string m_reason;
    std::optional<Time> m_lastData;
    std::optional<Time> m_deadline;
    int m_failures = 0;
    bool m_mute = false;
};

} // namespace agv::procedure
