// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include "core/anchor_survey.h"
#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "estimation/uwb/anchor_watch.h"
#include "link/serial_link.h"
#include "procedure/link_life.h"
#include "procedure/range_calibration.h"
#include "procedure/uwb_handshake.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_stream.h"
#include "session/anchor_pairs.h"
#include "session/anchor_statistics.h"
#include "session/rate_meter.h"
#include "session/uwb_tag_track.h"

#include <map>
#include <memory>
#include <set>
#include <vector>

namespace agv::session {

/// How long a UWB link waits for what, and where its ports are; tests wait less and have ports of their own.
struct UwbLinkParameters {
    procedure::LinkLifeParameters life = usualLife();
    procedure::UwbHandshakeParameters handshake;
    estimation::AnchorWatchSettings anchorWatch;
    link::SerialPortLister ports = link::availableSerialPorts;

    /// A unit that is plugged in and whose tags are all off is silent and well: it is not reopened soon.
    static procedure::LinkLifeParameters usualLife();
};

/// The way from the serial port of a UWB unit to the positions of its tags: link, life, handshake, decoder,
/// tracks, and the figures of the link panel. Lives in the session thread.
class UwbLink : public QObject {
    Q_OBJECT
public:
    UwbLink(const PlantLayout& plant, UwbLinkParameters parameters, QObject* parent);

    void open();
    void close();
    /// Another port than the plant file's; an open link is made anew.
    void setPort(const SerialPortChoice& port);
    /// Edited anchors, tags, heights and corrections hold at once. The link is made anew only for another
    /// port than the plant had before: one that setPort() chose stays.
    void setLayout(std::vector<UwbAnchor> anchors, UwbSettings settings);
    /// Of the ranges of a tag that stands at a known place; the result is in the snapshot.
    void startRangeCalibration(int tag, const procedure::CalibrationPlace& place, double duration_s);
    void cancelRangeCalibration() { m_calibration.cancel(); }
    /// Asks the unit for its version and configuration, clone or not.
    void ask();

    UwbSnapshot snapshot(Time now);
    /// Where the anchors of the plant stand by the last ranges between them.
    AnchorSurvey surveyAnchors(Time now) const;

signals:
    /// Every byte as it came, for recordings.
    void bytesReceived(const agv::link::Chunk& chunk);
    void stateChanged(agv::LinkState state, const QString& reason);
    /// Once for each anchor, until the layout changes.
    void anchorDoubted(int anchor, const QString& warning);
    /// `track` has new ranges of a tag that `agv` carries at `mount` (vehicle frame, m).
    void carriedTagMeasured(agv::RobotId agv, const agv::session::UwbTagTrack& track, agv::Point2 mount);
    /// A report with ranges, and the track with what it made of them.
    void tagMeasured(const agv::protocol::RangeSet& ranges, const agv::session::UwbTagTrack& track,
                     agv::Time arrival);
    /// Every byte that was sent, for recordings.
    void bytesSent(const agv::link::Chunk& chunk);
    void unitKnown(const QString& version, const QString& configuration);

private:
    struct Tag {
        explicit Tag(UwbTagTrack tagTrack) : track(std::move(tagTrack)) {}
        UwbTagTrack track;
        RateMeter rate;
    };

    void onConnected();
    void take(const link::Chunk& chunk);
    void takeReport(const protocol::TrekReport& report);
    void carryOut(procedure::LinkAction action);
    void carryOut(procedure::UwbHandshakeAction action);
    void takeUnit();
    void armTimer();
    Tag& tagOf(int id);
    UwbTag settingsOf(int id) const;
    void watchAnchors(int tag, const UwbTagTrack& track);
    LinkSnapshot linkSnapshot(Time now);

    std::vector<UwbAnchor> m_anchors;
    UwbSettings m_settings;
    SerialPortChoice m_port; ///< in use; the plant's until the operator chooses another
    link::SerialLink* m_link;
    QTimer* m_timer;
    procedure::LinkLife m_life;
    procedure::UwbHandshake m_handshake;
    LinkState m_reportedState = LinkState::Down;
    std::string m_reportedReason;
    bool m_unitReported = false;
    protocol::TrekStream m_stream;
    protocol::TrekRanges m_ranges;
    AnchorPairs m_anchorPairs;
    std::map<int, Tag> m_tags; ///< that were heard
    AnchorStatistics m_anchorStatistics;
    estimation::AnchorWatch m_anchorWatch;
    std::set<int> m_doubtedAnchors; ///< that were reported
    procedure::RangeCalibration m_calibration;
    RateMeter m_rate;
    std::optional<Time> m_lastReport;
};

} // namespace agv::session
