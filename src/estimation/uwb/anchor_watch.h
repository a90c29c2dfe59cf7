// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/recent_values.h"
#include "estimation/uwb/anchor_fault.h"

#include <optional>
#include <string>
#include <vector>

namespace agv::estimation {

/// An anchor whose ranges do not fit its place in the list.
struct AnchorDoubt {
    AnchorFault fault = AnchorFault::None; ///< Offset: moved or hidden, which of them is not known
    int anchor = 0;                        ///< index
    double size_m = 0.0;                   ///< Moved: how far; Offset: how much too long, negative: too short
    friend bool operator==(const AnchorDoubt&, const AnchorDoubt&) = default;
};

/// What is wrong and what to do, for the anchor's row.
std::string toText(const AnchorDoubt& doubt);

/// Decides from the ranges of one tag that an anchor does not stand where the list says.
///
///  * While the tag drives, one sample each quarter of a metre: the list is compared with one moved anchor,
///  for
///    each anchor. It is moved when its displacement is at least 100 mm and four times its deviation, takes
///    away a good part of the misfit, explains the samples clearly better than a displacement of any other
///    anchor and than an anchor that is hidden everywhere, and when ranges are too short where they must be:
///    a hidden anchor's never are. It is said when three decisions in a row agree.
///  * Otherwise only a constant offset of one anchor is looked for; of a tag that stands, in the medians of a
///    minute, so that whoever passes is no reason. It is said when it is at least 200 mm.
///
/// An anchor is named only when no other explains the ranges nearly as well. Reports with fewer than four
/// ranges do not count. Allocates only at construction.
class AnchorWatch {
public:
    static constexpr double leastDisplacement_m = 0.100;
    static constexpr double leastOffset_m = 0.200;
    static constexpr double persistence_s = 60.0;
    static constexpr double stepOfSamples_m = 0.25;
    static constexpr int samplesToDecide = 40;
    static constexpr int decisionsToSay = 3; ///< in a row; one each ten samples

    /// Places by AnchorRange::index; `height_m` of the tag.
    AnchorWatch(std::vector<Eigen::Vector3d> anchors, double height_m) : m_model(std::move(anchors), height_m)
    {}

    /// The ranges of one report of a tag that is at about `position`. Times never fall.
    void add(AnchorRanges ranges, const Eigen::Vector2d& position, double time_s);
    const std::optional<AnchorDoubt>& doubt() const { return m_doubt; }

private:
    static constexpr std::size_t standingKept = 64;

    void addDriven(const RangeSample& sample, double time_s);
    void addStanding(const RangeSample& sample, double time_s);
    std::optional<AnchorDoubt> movedAnchor() const;
    std::optional<AnchorDoubt> offsetAnchor(std::span<const RangeSample> samples) const;
    bool hasShortRanges(int anchor, const Eigen::Vector2d& displacement) const;
    RangeSample medianWhileStanding() const;

    AnchorFaultModel m_model;
    RecentValues<RangeSample, AnchorFaultModel::mostSamples> m_driven;
    RecentValues<RangeSample, standingKept> m_standing;       ///< one a second since the tag stands
    Eigen::Vector2d m_place = Eigen::Vector2d::Constant(1e9); ///< of the last driven sample
    double m_standsSince_s = 0.0;
    double m_lastStanding_s = 0.0;
    int m_newSamples = 0;
    std::optional<AnchorDoubt> m_suspicion; ///< of the last decision while driving
    int m_decisionsInARow = 0;
    std::optional<AnchorDoubt> m_doubt; ///< that is said
};

} // namespace agv::estimation
