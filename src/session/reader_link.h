// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include "core/snapshot.h"
#include "link/tcp_client_link.h"
#include "procedure/link_life.h"
#include "protocol/reader_stream.h"
#include "session/rate_meter.h"

#include <deque>
#include <optional>
#include <vector>

namespace agv::session {

/// The way from one reader's socket to tag reads: link, life, framer, decoder, and the figures of the link
/// panel. Lives in the session thread.
class ReaderLink : public QObject {
    Q_OBJECT
public:
    ReaderLink(int robot, Endpoint reader, QObject* parent);

    void open();
    void close();
    /// Takes effect at once when the link is open.
    void setEndpoint(const Endpoint& reader);

    bool isConnected() const { return m_life.isConnected(); }
    LinkSnapshot snapshot(Time now);
    std::vector<TagRead> recentReads(Time now);

signals:
    void tagRead(const agv::TagRead& read);
    /// Every byte as it came, for recordings.
    void bytesReceived(const agv::link::Chunk& chunk);
    void stateChanged(agv::LinkState state, const QString& reason);
    /// The connection is gone for another reason than silence: an idle reader is silent too.
    void lost(const QString& reason);

private:
    void take(const link::Chunk& chunk);
    void takeReport(const protocol::ReaderReport& report, Time firstByte);
    /// Carries out what the life asks for, arms its timer and reports a change of state.
    void carryOut(procedure::LinkAction action);

    std::string m_name;
    Endpoint m_reader;
    link::TcpClientLink* m_link;
    QTimer* m_timer;
    procedure::LinkLife m_life;
    LinkState m_reportedState = LinkState::Down;
    std::string m_reportedReason;
    protocol::ReaderStream m_stream;
    RateMeter m_rate;
    std::optional<Time> m_lastLine; ///< last line that made sense; noise shows only in the counts
    std::deque<TagRead> m_recent;
};

} // namespace agv::session
