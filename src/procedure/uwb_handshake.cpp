// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/uwb_handshake.h"

#include <algorithm>
#include <utility>

namespace agv::procedure {

namespace {

constexpr std::string_view answerBegin = "nVer";
constexpr std::string_view answerEnd = "\r\n";
/// Firmware 2.25 has a version of 15 bytes, and may leave the sixteenth out.
constexpr std::size_t longVersion = 16;
constexpr std::size_t shortVersion = 15;
constexpr std::size_t answerLength(std::size_t version) { return 1 + version + 1 + answerEnd.size(); }

std::string trimmedVersion(std::string_view version)
{
    while (!version.empty() && (version.back() == ' ' || version.back() == '\0'))
        version.remove_suffix(1);
    return std::string(version);
}

std::optional<UwbUnit> answerOf(std::string_view text, std::size_t versionLength)
{
    const auto isText = [](char c) { return (c >= ' ' && c <= '~') || c == '\0'; };
    const std::string_view version = text.substr(1, versionLength);
    if (text.size() < answerLength(versionLength) || text.substr(versionLength + 2, 2) != answerEnd ||
        !std::ranges::all_of(version, isText))
        return std::nullopt;
    const auto configuration = static_cast<std::uint8_t>(text[versionLength + 1]);
    return UwbUnit{trimmedVersion(version), decodeUwbConfiguration(configuration)};
}

} // namespace

UwbHandshakeAction UwbHandshake::opened(bool isTrekPort, Time now)
{
    closed();
    if (!isTrekPort) {
        refuse("The port is not the one of a TREK1000 unit (USB id 0483:5740): nothing is sent to it unless "
               "you ask "
               "for it");
        return UwbHandshakeAction::None;
    }
    m_state = UwbHandshakeState::Listening;
    m_deadline = now + m_parameters.listen;
    return UwbHandshakeAction::None;
}

UwbHandshakeAction UwbHandshake::bytes(std::string_view bytes, UwbDialect dialect, Time now)
{
    m_dialect = dialect;
    if (m_state == UwbHandshakeState::Listening) {
        if (isClone(dialect))
            refuse(std::string("The reports are those of a clone (") + toText(dialect) +
                   "): nothing is sent to it unless you ask for it");
        else if (dialect != UwbDialect::Unknown)
            return send(now);
        return UwbHandshakeAction::None;
    }
    if (m_state != UwbHandshakeState::Asked)
        return UwbHandshakeAction::None;
    m_unit = findAnswer(bytes);
    if (m_unit) {
        m_state = UwbHandshakeState::Quiet;
        m_heard.clear();
        m_deadline = *m_sentAt + m_parameters.silence;
        return onTimer(now);
    }
    return UwbHandshakeAction::None;
}

UwbHandshakeAction UwbHandshake::ask(Time now)
{
    if (m_state == UwbHandshakeState::Closed || m_state == UwbHandshakeState::Asked ||
        m_state == UwbHandshakeState::Quiet)
        return UwbHandshakeAction::None;
    m_operatorAsked = true;
    m_attempts = 0;
    m_unit.reset();
    return send(now);
}

UwbHandshakeAction UwbHandshake::onTimer(Time now)
{
    if (!m_deadline || now < *m_deadline)
        return UwbHandshakeAction::None;
    m_deadline.reset();
    switch (m_state) {
    case UwbHandshakeState::Listening:
        return send(now);
    case UwbHandshakeState::Asked:
        if (m_attempts < m_parameters.attempts && (m_operatorAsked || !isClone(m_dialect)))
            return send(now);
        m_state = UwbHandshakeState::Unanswered;
        m_reason =
            "The unit did not tell its version and configuration: the age of its ranges is measured from its "
            "reports instead";
        break;
    case UwbHandshakeState::Quiet:
        m_state = UwbHandshakeState::Known;
        break;
    case UwbHandshakeState::Closed:
    case UwbHandshakeState::Known:
    case UwbHandshakeState::NotAsked:
    case UwbHandshakeState::Unanswered:
        break;
    }
    return UwbHandshakeAction::None;
}

void UwbHandshake::closed() { *this = UwbHandshake(m_parameters); }

bool UwbHandshake::isSilenceExpected(Time now) const
{
    return m_sentAt && now >= *m_sentAt && now < *m_sentAt + m_parameters.silence;
}

UwbHandshakeAction UwbHandshake::send(Time now)
{
    ++m_attempts;
    m_state = UwbHandshakeState::Asked;
    m_reason.clear();
    m_heard.clear();
    m_sentAt = now;
    m_deadline = now + m_parameters.answerTimeout;
    return UwbHandshakeAction::SendRequest;
}

void UwbHandshake::refuse(std::string reason)
{
    m_state = UwbHandshakeState::NotAsked;
    m_reason = std::move(reason);
    m_deadline.reset();
}

/// Keeps in m_heard what may still become the answer.
std::optional<UwbUnit> UwbHandshake::findAnswer(std::string_view bytes)
{
    m_heard += bytes;
    for (;;) {
        const std::size_t begin = m_heard.find(answerBegin);
        if (begin == std::string::npos) {
            const std::size_t keep = std::min(m_heard.size(), answerBegin.size() - 1);
            m_heard.erase(0, m_heard.size() - keep);
            return std::nullopt;
        }
        m_heard.erase(0, begin);
        for (const std::size_t version : {shortVersion, longVersion})
            if (auto unit = answerOf(m_heard, version))
                return unit;
        if (m_heard.size() < answerLength(longVersion))
            return std::nullopt;
        m_heard.erase(0, 1);
    }
}

} // namespace agv::procedure
