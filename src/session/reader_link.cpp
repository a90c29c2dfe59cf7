// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/reader_link.h"

#include "session/wall_clock.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace agv::session {
namespace {

constexpr Duration recentFor = std::chrono::seconds(1);

std::chrono::milliseconds timerInterval(Duration left)
{
    return std::max(std::chrono::ceil<std::chrono::milliseconds>(left), std::chrono::milliseconds(0));
}

} // namespace

ReaderLink::ReaderLink(int robot, Endpoint reader, QObject* parent)
    : QObject(parent),
      m_name("RFID reader " + std::to_string(robot)),
      m_reader(std::move(reader)),
      m_link(new link::TcpClientLink(this)),
      m_timer(new QTimer(this))
{
    m_timer->setSingleShot(true);
    connect(m_timer, &QTimer::timeout, this, [this] { carryOut(m_life.onTimer(monotonicNow())); });
    connect(m_link, &link::TcpClientLink::connected, this, [this] {
        m_stream.reset();
        carryOut(m_life.connected(monotonicNow()));
    });
    connect(m_link, &link::TcpClientLink::received, this, &ReaderLink::take);
    connect(m_link, &link::TcpClientLink::failed, this, [this](bool transient, const QString& reason) {
        carryOut(m_life.failed(transient, reason.toStdString(), monotonicNow()));
    });
}

void ReaderLink::open() { carryOut(m_life.open(monotonicNow())); }

void ReaderLink::close() { carryOut(m_life.close()); }

void ReaderLink::setEndpoint(const Endpoint& reader)
{
    const bool wasOpen = m_life.state() != LinkState::Down;
    close();
    m_reader = reader;
    if (wasOpen)
        open();
}

void ReaderLink::take(const link::Chunk& chunk)
{
    emit bytesReceived(chunk);
    carryOut(m_life.data(chunk.time));
    const std::string_view bytes(chunk.bytes.constData(), static_cast<std::size_t>(chunk.bytes.size()));
    m_stream.feed(bytes, chunk.time, [this](const protocol::ReaderReport& report, Time firstByte) {
        takeReport(report, firstByte);
    });
}

void ReaderLink::takeReport(const protocol::ReaderReport& report, Time firstByte)
{
    m_rate.add(firstByte);
    m_lastLine = firstByte;
    const auto* read = std::get_if<protocol::CompleteRead>(&report);
    if (!read)
        return;
    m_recent.push_back({firstByte, read->uid, read->rssi});
    emit tagRead(m_recent.back());
}

void ReaderLink::carryOut(procedure::LinkAction action)
{
    if (action == procedure::LinkAction::Open)
        m_link->open(m_reader);
    else if (action == procedure::LinkAction::Close)
        m_link->close();

    if (const std::optional<Time> deadline = m_life.deadline())
        m_timer->start(timerInterval(*deadline - monotonicNow()));
    else
        m_timer->stop();

    const LinkState before = std::exchange(m_reportedState, m_life.state());
    if (before == m_life.state() && m_reportedReason == m_life.reason())
        return;
    m_reportedReason = m_life.reason();
    const QString reason = QString::fromStdString(m_life.reason());
    emit stateChanged(m_life.state(), reason);
    if (action == procedure::LinkAction::Close && !m_life.isMute())
        emit lost(m_life.state() == LinkState::Down ? QStringLiteral("it was closed") : reason);
}

LinkSnapshot ReaderLink::snapshot(Time now)
{
    LinkSnapshot snapshot;
    snapshot.name = m_name;
    snapshot.address = toText(m_reader);
    snapshot.state = m_life.state();
    snapshot.reason = m_life.reason();
    snapshot.messagesPerSecond = m_rate.perSecond(now);
    if (m_lastLine)
        snapshot.dataAge_s = std::max(0.0, secondsFrom(now - *m_lastLine));
    const protocol::ReaderStream::Counts counts = m_stream.counts();
    snapshot.received = counts.complete + counts.incomplete + counts.other;
    snapshot.dropped = counts.droppedTotal();
    snapshot.dropDetail = dropDetail(counts);
    if (const std::optional<Time> retry = m_life.retryAt())
        snapshot.retryIn_s = std::max(0.0, secondsFrom(*retry - now));
    return snapshot;
}

std::vector<TagRead> ReaderLink::recentReads(Time now)
{
    while (!m_recent.empty() && m_recent.front().time + recentFor < now)
        m_recent.pop_front();
    return {m_recent.begin(), m_recent.end()};
}

} // namespace agv::session
