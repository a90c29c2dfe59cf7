// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/snapshot.h"
#include "model/time_series.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace agv::model {

/// What can be plotted together: same unit, same axis.
enum class PlotGroup : std::uint8_t {
    Position,      ///< x and y of an AGV, mm
    Heading,       ///< of an AGV, degrees
    PositionError, ///< distance from the reference, mm
    HeadingError,  ///< from the reference, degrees
    Uncertainty,   ///< 95 % radius of the position, mm
    Ranges,        ///< of a UWB tag to each anchor, mm
    Residuals,     ///< of these ranges: measured minus expected, mm
    Signal,        ///< RSSI of the floor tag read last
    WheelSpeeds,   ///< commanded, mm/s
    Charge,        ///< of the battery, %
    Voltage,       ///< of the battery, V
    Rates,         ///< messages a second of each link
    Ages,          ///< of the last message of each link, ms
};
inline constexpr int plotGroupCount = static_cast<int>(PlotGroup::Ages) + 1;

/// Of one curve: the group, whose it is (AGV, or UWB tag of Ranges and Residuals), and which part of it (0 or
/// 1: x and y, left and right, reader and robot; or the number of the anchor).
struct SeriesKey {
    PlotGroup group = PlotGroup::Position;
    int subject = 0;
    int part = 0;
    friend auto operator<=>(const SeriesKey&, const SeriesKey&) = default;
};

/// Collects the curves of a session from its snapshots. GUI thread.
class PlotFeed {
    Q_DECLARE_TR_FUNCTIONS(agv::model::PlotFeed)
public:
    /// A value that has not changed is noted this seldom, s.
    static constexpr double restInterval_s = 0.2;

    void add(const PlantSnapshot& snapshot);
    void clear();

    const std::map<SeriesKey, TimeSeries>& series() const { return m_series; }
    /// The curves of a group; of one subject, or of all.
    std::vector<SeriesKey> keysOf(PlotGroup group, std::optional<int> subject) const;
    std::vector<int> subjectsOf(PlotGroup group) const;
    double now_s() const { return m_now_s; } ///< since the first snapshot
    /// Wall clock of t = 0, ms since 1970, UTC.
    std::int64_t began_utc_ms() const { return m_began_utc_ms; }

    /// Where an AGV truly is, for its errors from now on; nullopt: unknown.
    void setReference(int robot, std::optional<Pose2> reference);
    std::optional<Pose2> reference(int robot) const;
    /// The pose that the last snapshot had.
    std::optional<Pose2> pose(int robot) const;

    static QString name(PlotGroup group);
    /// "mm", "°", "mm/s"; never empty.
    static QString unit(PlotGroup group);
    static bool isOfTag(PlotGroup group)
    {
        return group == PlotGroup::Ranges || group == PlotGroup::Residuals;
    }
    /// "AGV 1 x", "Tag 5, anchor 2"
    static QString name(const SeriesKey& key);
    /// "agv1_x_mm", for the head of a CSV file; not translated.
    static QString columnName(const SeriesKey& key);

private:
    void note(SeriesKey key, double value);
    void addAgv(const AgvSnapshot& agv);
    void addTag(const UwbTagSnapshot& tag);

    std::map<SeriesKey, TimeSeries> m_series;
    std::map<int, Pose2> m_references;
    std::map<int, Pose2> m_poses;
    std::optional<Time> m_began;
    std::int64_t m_began_utc_ms = 0;
    double m_now_s = 0.0;
};

} // namespace agv::model
