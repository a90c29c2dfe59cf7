// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/uwb_line.h"

#include "session/wall_clock.h"

namespace agv::session {

UwbLine::UwbLine(const PlantLayout& plant, const UwbLinkParameters& parameters, EventLog& events,
                 QObject* parent)
    : QObject(parent),
      m_events(events),
      m_link(new UwbLink(plant, parameters, this))
{
    connect(m_link, &UwbLink::bytesReceived, this, [this](const link::Chunk& chunk) {
        emit bytesReceived(chunk);
        emit changed();
    });
    connect(m_link, &UwbLink::stateChanged, this, &UwbLine::logState);
    connect(m_link, &UwbLink::anchorDoubted, this, [this](int anchor, const QString& warning) {
        log(EventLevel::Warning, "Anchor " + std::to_string(anchor) + ": " + warning.toStdString());
    });
    connect(m_link, &UwbLink::unitKnown, this, [this](const QString& version, const QString& configuration) {
        log(EventLevel::Info, "The unit is " + version.toStdString() + ": " + configuration.toStdString());
    });
}

void UwbLine::logState(LinkState state, const QString& reason)
{
    emit changed();
    const std::string text = reason.toStdString();
    switch (state) {
    case LinkState::Up:
        m_troubles.clear();
        log(EventLevel::Info, "Connected");
        break;
    case LinkState::Down:
        m_troubles.clear();
        log(EventLevel::Info, "Closed");
        break;
    case LinkState::Waiting:
    case LinkState::Failed:
        if (m_troubles.insert(text).second)
            log(EventLevel::Warning, text);
        break;
    case LinkState::Opening:
    case LinkState::Silent:
        break;
    }
}

void UwbLine::log(EventLevel level, const std::string& text)
{
    m_events.add(level, "UWB", text, monotonicNow());
}

} // namespace agv::session
