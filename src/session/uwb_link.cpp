// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/uwb_link.h"

#include "estimation/uwb/anchor_survey.h"
#include "session/wall_clock.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace agv::session {
namespace {

double steadySeconds(Time time) { return secondsFrom(time.time_since_epoch()); }

bool areSamePlaces(const std::vector<UwbAnchor>& one, const std::vector<UwbAnchor>& other)
{
    return std::ranges::equal(one, other, [](const UwbAnchor& a, const UwbAnchor& b) {
        return a.id == b.id && a.x == b.x && a.y == b.y && a.z == b.z;
    });
}

std::string configurationText(const UwbConfiguration& unit)
{
    return std::string(toText(unit.role)) + " " + std::to_string(unit.address) + ", channel " +
           std::to_string(unit.channel) + ", " + (unit.fastMode ? "6.81 Mb/s" : "110 kb/s");
}

} // namespace

procedure::LinkLifeParameters UwbLinkParameters::usualLife()
{
    procedure::LinkLifeParameters life;
    life.lostAfter = std::chrono::seconds(15);
    life.muteLostAfter = std::chrono::seconds(60);
    life.hints = {.noAnswer = "unplug the unit and plug it in again",
                  .silent = "no UWB tag is switched on or in reach",
                  .stillSilent = "no UWB tag is switched on or in reach, or the unit hangs"};
    return life;
}

UwbLink::UwbLink(const PlantLayout& plant, UwbLinkParameters parameters, QObject* parent)
    : QObject(parent),
      m_anchors(plant.anchors),
      m_settings(plant.uwb),
      m_port(plant.uwb.port),
      m_link(new link::SerialLink(std::move(parameters.ports), this)),
      m_timer(new QTimer(this)),
      m_life(parameters.life),
      m_handshake(parameters.handshake),
      m_anchorStatistics(plant.anchors),
      m_anchorWatch(parameters.anchorWatch)
{
    m_stream.dialect().setOverride(m_settings.dialect);
    m_timer->setSingleShot(true);
    connect(m_timer, &QTimer::timeout, this, [this] {
        const Time now = monotonicNow();
        carryOut(m_handshake.onTimer(now));
        carryOut(m_life.onTimer(now));
    });
    connect(m_link, &link::SerialLink::connected, this, &UwbLink::onConnected);
    connect(m_link, &link::SerialLink::received, this, &UwbLink::take);
    connect(m_link, &link::SerialLink::failed, this, [this](bool transient, const QString& reason) {
        m_handshake.closed();
        carryOut(m_life.failed(transient, reason.toStdString(), monotonicNow()));
    });
}

void UwbLink::open() { carryOut(m_life.open(monotonicNow())); }

void UwbLink::close() { carryOut(m_life.close()); }

void UwbLink::setPort(const SerialPortChoice& port)
{
    const bool wasOpen = m_life.state() != LinkState::Down;
    close();
    m_port = port;
    if (wasOpen)
        open();
}

void UwbLink::setLayout(std::vector<UwbAnchor> anchors, UwbSettings settings)
{
    const bool isOtherPort = settings.port != m_settings.port;
    if (!areSamePlaces(anchors, m_anchors))
        m_calibration.abort("The anchors were changed meanwhile: start the calibration again");
    m_anchors = std::move(anchors);
    m_settings = std::move(settings);
    m_stream.dialect().setOverride(m_settings.dialect);
    m_anchorStatistics.setAnchors(m_anchors);
    bool isAnyAnew = false;
    for (auto& [id, tag] : m_tags)
        isAnyAnew |= tag.track.setLayout(settingsOf(id), m_anchors, m_settings.corrections);
    if (isAnyAnew) {
        m_anchorStatistics.forgetResiduals();
        m_anchorWatch.clear();
        m_doubtedAnchors.clear();
    }
    if (isOtherPort)
        setPort(m_settings.port);
}

void UwbLink::startRangeCalibration(int tag, const procedure::CalibrationPlace& place, double duration_s)
{
    m_calibration.start(tag, place, m_anchors, duration_s, monotonicNow());
}

void UwbLink::ask()
{
    carryOut(m_handshake.ask(monotonicNow()));
    armTimer();
}

void UwbLink::onConnected()
{
    const Time now = monotonicNow();
    m_stream.reset();
    m_ranges.reset();
    m_ranges.setReportPeriod({}); // it may be another unit
    m_anchorPairs.clear();
    m_unitReported = false;
    carryOut(m_life.connected(now));
    carryOut(m_handshake.opened(m_link->port()->usb == trekUsbId, now));
    armTimer();
}

void UwbLink::take(const link::Chunk& chunk)
{
    emit bytesReceived(chunk);
    const std::string_view bytes(chunk.bytes.constData(), static_cast<std::size_t>(chunk.bytes.size()));
    m_stream.feed(bytes, chunk.time, [this](const protocol::TrekReport& report) { takeReport(report); });
    carryOut(m_handshake.bytes(bytes, m_stream.dialect().dialect(), chunk.time));
    takeUnit();
    carryOut(m_life.data(chunk.time));
}

void UwbLink::takeReport(const protocol::TrekReport& report)
{
    m_rate.add(report.firstByte);
    m_lastReport = report.firstByte;
    const bool isOfATag =
        report.kind != protocol::TrekLineKind::Raw && report.kind != protocol::TrekLineKind::Anchors;
    const protocol::RangeSet ranges = m_ranges.read(report);
    m_anchorPairs.add(ranges);
    if (!isOfATag)
        return;
    Tag& tag = tagOf(report.tag);
    tag.rate.add(report.firstByte);
    tag.track.take(ranges, steadySeconds(report.firstByte));
    for (const RangeMeasurement& range : ranges) {
        m_anchorStatistics.heard(range.anchor, report.firstByte, Time(durationFromSeconds(range.time_s)));
        m_calibration.add(range, report.firstByte);
    }
    m_anchorStatistics.add(tag.track.shown());
    if (ranges.empty())
        return;
    emit tagMeasured(ranges, tag.track, report.firstByte);
    watchAnchors(report.tag, tag.track);
    if (const UwbTag& carried = tag.track.tag(); carried.agv)
        emit carriedTagMeasured(*carried.agv, tag.track, carried.mount);
}

void UwbLink::watchAnchors(int tag, const UwbTagTrack& track)
{
    m_anchorWatch.add(tag, track.corrected(), track.height_m(), track.measured_s());
    const std::optional<estimation::AnchorDoubt>& doubt = m_anchorWatch.doubt();
    if (!doubt)
        return;
    const int anchor = m_anchors[static_cast<std::size_t>(doubt->index)].id;
    if (m_doubtedAnchors.insert(anchor).second)
        emit anchorDoubted(anchor, QString::fromStdString(toText(*doubt)));
}

/// What the unit says of itself gives the age of its ranges.
void UwbLink::takeUnit()
{
    const std::optional<UwbUnit>& unit = m_handshake.unit();
    if (!unit || std::exchange(m_unitReported, true))
        return;
    m_ranges.setReportPeriod(unit->configuration.reportPeriod_s());
    emit unitKnown(QString::fromStdString(unit->version),
                   QString::fromStdString(configurationText(unit->configuration)));
}

UwbLink::Tag& UwbLink::tagOf(int id)
{
    if (const auto known = m_tags.find(id); known != m_tags.end())
        return known->second;
    return m_tags.emplace(id, Tag(UwbTagTrack(settingsOf(id), m_anchors, m_settings.corrections)))
        .first->second;
}

/// As the plant lists the tag, or what holds for those that it does not.
UwbTag UwbLink::settingsOf(int id) const
{
    const auto listed = std::ranges::find(m_settings.tags, id, &UwbTag::id);
    if (listed != m_settings.tags.end())
        return *listed;
    return {.id = id, .label = {}, .agv = {}, .z_m = m_settings.tagHeight_m, .mount = {}};
}

void UwbLink::carryOut(procedure::UwbHandshakeAction action)
{
    using procedure::UwbHandshake;
    if (action != procedure::UwbHandshakeAction::SendRequest)
        return;
    const QByteArray request(UwbHandshake::request.data(), UwbHandshake::request.size());
    if (m_link->write(request))
        emit bytesSent({request, monotonicNow()});
}

void UwbLink::carryOut(procedure::LinkAction action)
{
    if (action == procedure::LinkAction::Close || action == procedure::LinkAction::Open)
        m_handshake.closed();
    if (action == procedure::LinkAction::Open)
        m_link->open(m_port);
    else if (action == procedure::LinkAction::Close)
        m_link->close();
    armTimer();
    const LinkState before = std::exchange(m_reportedState, m_life.state());
    if (before == m_life.state() && m_reportedReason == m_life.reason())
        return;
    m_reportedReason = m_life.reason();
    emit stateChanged(m_life.state(), QString::fromStdString(m_life.reason()));
}

void UwbLink::armTimer()
{
    std::optional<Time> next = m_life.deadline();
    if (const auto handshake = m_handshake.deadline(); handshake && (!next || *handshake < *next))
        next = handshake;
    if (!next)
        return m_timer->stop();
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(*next - monotonicNow());
    m_timer->start(std::max(left, std::chrono::milliseconds(0)));
}

UwbSnapshot UwbLink::snapshot(Time now)
{
    UwbSnapshot snapshot;
    snapshot.link = linkSnapshot(now);
    snapshot.dialect = m_stream.dialect().dialect();
    snapshot.dialectIsChosen = m_settings.dialect.has_value();
    snapshot.unit = m_handshake.unit();
    snapshot.unitNote = m_handshake.reason();
    snapshot.anchorPairs = m_anchorPairs.snapshot(steadySeconds(now));
    for (auto& [id, tag] : m_tags) {
        UwbTagSnapshot entry = tag.track.snapshot(steadySeconds(now));
        const protocol::TagTraffic& traffic = m_ranges.traffic(id);
        entry.reportsPerSecond = tag.rate.perSecond(now);
        entry.reports = traffic.reports;
        entry.missed = traffic.missed;
        snapshot.missed += traffic.missed;
        snapshot.tags.push_back(std::move(entry));
    }
    snapshot.anchors = m_anchorStatistics.snapshot(now);
    if (const auto& doubt = m_anchorWatch.doubt())
        snapshot.anchors[static_cast<std::size_t>(doubt->index)].warning = toText(*doubt);
    m_calibration.onTimer(now);
    snapshot.calibration = m_calibration.snapshot(now);
    return snapshot;
}

AnchorSurvey UwbLink::surveyAnchors(Time now) const
{
    return estimation::surveyAnchors(m_anchorPairs.snapshot(steadySeconds(now)), m_anchors);
}

LinkSnapshot UwbLink::linkSnapshot(Time now)
{
    LinkSnapshot link;
    link.name = "UWB";
    link.address =
        m_life.isConnected() && m_link->port() ? link::toText(*m_link->port()).toStdString() : toText(m_port);
    link.state = m_life.state();
    link.reason = m_life.reason();
    link.messagesPerSecond = m_rate.perSecond(now);
    if (m_lastReport)
        link.dataAge_s = std::max(0.0, secondsFrom(now - *m_lastReport));
    protocol::TrekStream::Counts counts = m_stream.counts();
    // What units are known to print is no loss.
    for (std::size_t i = 0; i < protocol::trekDropCount; ++i)
        if (!isDamage(static_cast<protocol::TrekDrop>(i)))
            counts.dropped[i] = 0;
    link.received = counts.reports;
    link.dropped = counts.damaged();
    link.dropDetail = dropDetail(counts);
    if (const std::optional<Time> retry = m_life.retryAt())
        link.retryIn_s = std::max(0.0, secondsFrom(*retry - now));
    return link;
}

} // namespace agv::session
