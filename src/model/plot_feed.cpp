// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/plot_feed.h"

#include "core/units.h"
#include "model/uncertainty.h"

#include <QDateTime>

#include <algorithm>

namespace agv::model {
namespace {

constexpr double mm = 1e3;

QString partName(const SeriesKey& key)
{
    static const char* const axes[] = {"x", "y"};
    static const char* const wheels[] = {"left", "right"};
    static const char* const links[] = {"reader", "robot"};
    const auto part = static_cast<std::size_t>(key.part);
    switch (key.group) {
    case PlotGroup::Position:
        return QString::fromLatin1(axes[part]);
    case PlotGroup::WheelSpeeds:
        return QString::fromLatin1(wheels[part]);
    case PlotGroup::Rates:
    case PlotGroup::Ages:
        return QString::fromLatin1(links[part]);
    default:
        return {};
    }
}

} // namespace

void PlotFeed::clear()
{
    m_series.clear();
    m_poses.clear();
    m_began.reset();
    m_now_s = 0.0;
}

void PlotFeed::note(SeriesKey key, double value)
{
    TimeSeries& series = m_series[key];
    if (!series.empty() && series.back().value == value && m_now_s - series.back().t < restInterval_s)
        return;
    series.append(m_now_s, value);
}

void PlotFeed::add(const PlantSnapshot& snapshot)
{
    if (!m_began) {
        m_began = snapshot.time;
        m_began_utc_ms = QDateTime::currentMSecsSinceEpoch();
    }
    m_now_s = secondsFrom(snapshot.time - *m_began);
    for (const AgvSnapshot& agv : snapshot.agvs)
        addAgv(agv);
    if (!snapshot.uwb)
        return;
    for (const UwbTagSnapshot& tag : snapshot.uwb->tags)
        addTag(tag);
}

void PlotFeed::addAgv(const AgvSnapshot& agv)
{
    const int robot = agv.id.number;
    if (agv.pose) {
        const Pose2& pose = *agv.pose;
        m_poses.insert_or_assign(robot, pose);
        note({PlotGroup::Position, robot, 0}, mm * pose.position.x);
        note({PlotGroup::Position, robot, 1}, mm * pose.position.y);
        note({PlotGroup::Heading, robot, 0}, degFromRad(pose.heading));
        note({PlotGroup::Uncertainty, robot, 0}, mm * ellipse95(agv.covariance).major_m);
        if (const std::optional<Pose2> truth = reference(robot)) {
            note({PlotGroup::PositionError, robot, 0}, mm * distance(pose.position, truth->position));
            note({PlotGroup::HeadingError, robot, 0}, degFromRad(wrapAngle(pose.heading - truth->heading)));
        }
    }
    if (!agv.recentReads.empty())
        note({PlotGroup::Signal, robot, 0}, agv.recentReads.back().rssi);
    note({PlotGroup::WheelSpeeds, robot, 0}, mm * agv.commanded.left);
    note({PlotGroup::WheelSpeeds, robot, 1}, mm * agv.commanded.right);
    if (agv.battery) {
        note({PlotGroup::Voltage, robot, 0}, agv.battery->voltage_V);
        if (agv.battery->capacity_Ah > 0.0)
            note({PlotGroup::Charge, robot, 0}, 100.0 * agv.battery->charge_Ah / agv.battery->capacity_Ah);
    }
    const LinkSnapshot* links[] = {&agv.readerLink, &agv.robotLink};
    for (int part = 0; part < 2; ++part) {
        note({PlotGroup::Rates, robot, part}, links[part]->messagesPerSecond);
        if (links[part]->dataAge_s)
            note({PlotGroup::Ages, robot, part}, 1e3 * *links[part]->dataAge_s);
    }
}

void PlotFeed::addTag(const UwbTagSnapshot& tag)
{
    for (const UwbRangeSnapshot& range : tag.ranges) {
        note({PlotGroup::Ranges, tag.id, range.anchor}, mm * range.range_m);
        if (range.residual_m)
            note({PlotGroup::Residuals, tag.id, range.anchor}, mm * *range.residual_m);
    }
}

std::vector<SeriesKey> PlotFeed::keysOf(PlotGroup group, std::optional<int> subject) const
{
    std::vector<SeriesKey> keys;
    for (const auto& [key, series] : m_series) {
        if (key.group == group && (!subject || key.subject == *subject))
            keys.push_back(key);
    }
    return keys;
}

std::vector<int> PlotFeed::subjectsOf(PlotGroup group) const
{
    std::vector<int> subjects;
    for (const auto& [key, series] : m_series) {
        if (key.group == group && (subjects.empty() || subjects.back() != key.subject))
            subjects.push_back(key.subject);
    }
    return subjects;
}

void PlotFeed::setReference(int robot, std::optional<Pose2> reference)
{
    if (reference)
        m_references.insert_or_assign(robot, *reference);
    else
        m_references.erase(robot);
    // The errors before were from another place.
    m_series.erase({PlotGroup::PositionError, robot, 0});
    m_series.erase({PlotGroup::HeadingError, robot, 0});
}

std::optional<Pose2> PlotFeed::reference(int robot) const
{
    const auto found = m_references.find(robot);
    return found == m_references.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Pose2> PlotFeed::pose(int robot) const
{
    const auto found = m_poses.find(robot);
    return found == m_poses.end() ? std::nullopt : std::optional(found->second);
}

QString PlotFeed::name(PlotGroup group)
{
    switch (group) {
    case PlotGroup::Position:
        return tr("Position");
    case PlotGroup::Heading:
        return tr("Heading");
    case PlotGroup::PositionError:
        return tr("Position error");
    case PlotGroup::HeadingError:
        return tr("Heading error");
    case PlotGroup::Uncertainty:
        return tr("Position uncertainty, 95 %");
    case PlotGroup::Ranges:
        return tr("UWB ranges");
    case PlotGroup::Residuals:
        return tr("UWB residuals");
    case PlotGroup::Signal:
        return tr("RSSI of floor tags");
    case PlotGroup::WheelSpeeds:
        return tr("Wheel speeds");
    case PlotGroup::Charge:
        return tr("Battery charge");
    case PlotGroup::Voltage:
        return tr("Battery voltage");
    case PlotGroup::Rates:
        return tr("Message rates");
    case PlotGroup::Ages:
        return tr("Age of the last message");
    }
    return {};
}

QString PlotFeed::unit(PlotGroup group)
{
    switch (group) {
    case PlotGroup::Heading:
    case PlotGroup::HeadingError:
        return QStringLiteral("°");
    case PlotGroup::WheelSpeeds:
        return QStringLiteral("mm/s");
    case PlotGroup::Signal:
        return tr("steps");
    case PlotGroup::Charge:
        return QStringLiteral("%");
    case PlotGroup::Voltage:
        return QStringLiteral("V");
    case PlotGroup::Rates:
        return QStringLiteral("/s");
    case PlotGroup::Ages:
        return QStringLiteral("ms");
    default:
        return QStringLiteral("mm");
    }
}

QString PlotFeed::name(const SeriesKey& key)
{
    if (isOfTag(key.group))
        return tr("Tag %1, anchor %2").arg(key.subject).arg(key.part);
    const QString agv = tr("AGV %1").arg(key.subject);
    switch (key.group) {
    case PlotGroup::Position:
        return agv + QLatin1Char(' ') + partName(key);
    case PlotGroup::WheelSpeeds:
        return key.part == 0 ? tr("AGV %1 left").arg(key.subject) : tr("AGV %1 right").arg(key.subject);
    case PlotGroup::Rates:
    case PlotGroup::Ages:
        return key.part == 0 ? tr("AGV %1 RFID").arg(key.subject) : tr("AGV %1 robot").arg(key.subject);
    default:
        return agv;
    }
}

QString PlotFeed::columnName(const SeriesKey& key)
{
    static const char* const stems[plotGroupCount] = {
        "",     "heading", "position_error", "heading_error", "uncertainty95", "range", "residual",
        "rssi", "wheel",   "charge",         "voltage",       "rate",          "age"};
    static const char* const units[plotGroupCount] = {"mm",    "deg",  "mm",      "deg", "mm",    "mm", "mm",
                                                      "steps", "mm_s", "percent", "V",   "per_s", "ms"};
    const auto group = static_cast<std::size_t>(key.group);
    QStringList parts{isOfTag(key.group) ? QStringLiteral("tag%1").arg(key.subject)
                                         : QStringLiteral("agv%1").arg(key.subject)};
    if (*stems[group] != '\0')
        parts << QString::fromLatin1(stems[group]);
    if (isOfTag(key.group))
        parts << QStringLiteral("anchor%1").arg(key.part);
    else if (const QString part = partName(key); !part.isEmpty())
        parts << part;
    parts << QString::fromLatin1(units[group]);
    return parts.join(QLatin1Char('_'));
}

} // namespace agv::model
