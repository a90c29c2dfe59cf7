// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "core/uwb_unit.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace agv::procedure {

struct UwbHandshakeParameters {
    Duration listen = std::chrono::seconds(1); ///< before a unit that says nothing is asked
    Duration answerTimeout = std::chrono::milliseconds(1500);
    Duration silence = std::chrono::seconds(1); ///< of the unit after any command that ends with $
    int attempts = 2;
};

enum class UwbHandshakeState : std::uint8_t {
    Closed,     ///< no port
    Listening,  ///< finding out by listening whether the unit may be asked
    Asked,      ///< the request is sent
    Quiet,      ///< answered; the unit is silent for the rest of its second
    Known,      ///< unit() is valid
    NotAsked,   ///< a clone or a foreign port: nothing was sent, reason() says why
    Unanswered, ///< asked, and no answer; its reports are used all the same
};

/// What the caller must do with the port.
enum class UwbHandshakeAction : std::uint8_t {
    None,
    SendRequest, ///< write UwbHandshake::request
};

/// Asks a UWB unit for its version and configuration, and switches its raw reports off, as a pure state
/// machine. Nothing is ever sent to a clone unless the operator asks for it:
/// | state     | event                                       | next      | action      |
/// |-----------|---------------------------------------------|-----------|-------------|
/// | any       | opened, port of a TREK1000 (USB 0483:5740)  | Listening |             |
/// | any       | opened, any other port                      | NotAsked  |             |
/// | Listening | bytes, the dialect is of a clone            | NotAsked  |             |
/// | Listening | bytes, the dialect is TREK's own            | Asked     | SendRequest |
/// | Listening | listen is over                              | Asked     | SendRequest |
/// | Asked     | bytes complete the answer                   | Quiet     |             |
/// | Asked     | no answer, attempts left, dialect no clone's | Asked    | SendRequest |
/// | Asked     | no answer otherwise                         | Unanswered |            |
/// | Quiet     | silence is over                             | Known     |             |
/// | any but Closed, Asked, Quiet | ask (the operator)       | Asked     | SendRequest |
/// | any       | closed                                      | Closed    |             |
/// Everything else is ignored. The answer is "n", 16 bytes of version, the configuration byte, CR LF. That
/// byte may itself be a CR or LF (0x0A: anchor 0 at 6.81 Mb/s), so the answer is found by its length, not as
/// a line. It may stand between reports, in any number of reads.
class UwbHandshake {
public:
    /// Version and configuration, and no more raw reports. Five bytes, no line end.
    static constexpr std::string_view request = "decA$";

    explicit UwbHandshake(UwbHandshakeParameters parameters = {}) : m_parameters(parameters) {}

    /// isTrekPort: the USB id is 0483:5740.
    UwbHandshakeAction opened(bool isTrekPort, Time now);
    /// Everything that the port gave; `dialect` as known after these bytes.
    UwbHandshakeAction bytes(std::string_view bytes, UwbDialect dialect, Time now);
    /// The operator wants the unit to be asked, clone or not.
    UwbHandshakeAction ask(Time now);
    UwbHandshakeAction onTimer(Time now);
    void closed();

    /// When onTimer must be called.
    std::optional<Time> deadline() const { return m_deadline; }
    UwbHandshakeState state() const { return m_state; }
    /// Why the unit is not known, in plain English; empty otherwise.
    const std::string& reason() const { return m_reason; }
    /// What the unit said; stays until the port is closed or it is asked again.
    const std::optional<UwbUnit>& unit() const { return m_unit; }
    /// The unit is silent because it was asked: no reason to think that it is gone.
    bool isSilenceExpected(Time now) const;

private:
    UwbHandshakeAction send(Time now);
    void refuse(std::string reason);
    std::optional<UwbUnit> findAnswer(std::string_view bytes);

    UwbHandshakeParameters m_parameters;
    UwbHandshakeState m_state = UwbHandshakeState::Closed;
    std::string m_reason;
    std::string m_heard; ///< what may be the beginning of the answer
    std::optional<UwbUnit> m_unit;
    std::optional<Time> m_deadline;
    std::optional<Time> m_sentAt;
    UwbDialect m_dialect = UwbDialect::Unknown;
    int m_attempts = 0;
    bool m_operatorAsked = false;
};

} // namespace agv::procedure
