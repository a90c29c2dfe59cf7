// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "estimation/uwb/anchor_range.h"

#include <cstdint>
#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace agv::estimation {

enum class AnchorDoubtKind : std::uint8_t {
    Moved,   ///< its ranges fit another place
    TooLong, ///< moved or hidden: the tags do not come round enough to tell
    TooShort ///< moved: nothing makes ranges shorter
};

/// An anchor that does not stand where the list says.
struct AnchorDoubt {
    int index = 0; ///< AnchorRange::index
    AnchorDoubtKind kind = AnchorDoubtKind::Moved;
    double amount_m = 0.0; ///< Moved: how far; else: by how much ranges are too long or short, > 0
    Point2 displacement;   ///< Moved: from the place in the list, m
    friend bool operator==(const AnchorDoubt&, const AnchorDoubt&) = default;
};

/// What is wrong and what to do about it, without the number of the anchor; plain English.
std::string toText(const AnchorDoubt& doubt);

struct AnchorWatchSettings {
    double sampleEvery_s = 0.5; ///< of each tag one report in this time is kept
    double window_s = 120.0;    ///< how long it is kept
    int mostReports = 300;      ///< kept in all
    double decideEvery_s = 5.0;
    int reportsNeeded = 40; ///< of the anchor, in the window

    double sd_m = 0.06;      ///< of a range with line of sight: noise, reflections, what calibration leaves
    double delaySd_m = 0.08; ///< of what all ranges of an anchor have in common without an obstruction
    double gateSds = 3.0;    ///< what is farther off counts as this far: obstructions of single ranges

    double leastMove_m = 0.10;
    double leastBias_m = 0.15;   ///< TooLong, TooShort
    double significantSds = 3.0; ///< both
    double moved_s = 10.0;       ///< the decision must last so long: Moved
    double hidden_s = 60.0;      ///< the same: TooLong, TooShort
    double explained = 0.5;      ///< the most that may be left of the misfit
    double clearer = 2.0;        ///< so many times the misfit that is left with the next likely anchor
};

/// Watches whether the anchors stand where the list says. Each hypothesis is that one anchor does not: then
/// the others alone give the place p of the tag in every report (four ranges or more), and the ranges of the
/// one tell how it is wrong,
///     moved:   r = |p - (a + d)| + b, b as small as delays are
///     hidden:  r = |p - a| + b, any b
/// fitted to all reports of the window with weights that fall with the residual. When the tags come round,
/// ranges of a moved anchor are too long from some places and too short from others, and the first fits
/// better; when they stand still both fit, and the anchor is not called moved. The hypothesis must explain
/// most of the misfit of the list, and more of it than that of any other anchor: two anchors moved at once
/// are not told. Heights are believed.
///
/// Takes no memory once the window has been filled.
class AnchorWatch {
public:
    explicit AnchorWatch(const AnchorWatchSettings& settings = {});

    /// Forgets everything: the list has changed.
    void clear();
    /// Ranges of one report of a tag, corrected; `time_s` never falls by much.
    void add(int tag, AnchorRanges ranges, double height_m, double time_s);
    /// As of the last decision.
    const std::optional<AnchorDoubt>& doubt() const { return m_doubt; }

private:
    struct Report {
        double time_s = 0.0;
        double height_m = 0.0;
        Eigen::Vector2d place = Eigen::Vector2d::Zero(); ///< by all ranges
        AnchorRangeList ranges;
    };
    /// A range of the anchor in question from a place that the others gave.
    struct Sight {
        Eigen::Vector3d fromAnchor = Eigen::Vector3d::Zero(); ///< the tag, seen from the place in the list
        double range_m = 0.0;
        double variance = 0.0;
    };
    struct Fit {
        double bias_m = 0.0;
        Eigen::Vector2d move = Eigen::Vector2d::Zero();
        Eigen::Matrix2d moveCovariance = Eigen::Matrix2d::Zero();
        double cost = 0.0;
    };
    struct Hypothesis {
        int index = -1;
        Fit moved;                 ///< d, and b as small as delays are
        Fit hidden;                ///< any b, no d
        double residual_m = 0.0;   ///< median of range minus listed distance
        double residualSd_m = 0.0; ///< of one, by the errors of all ranges that it came from
        double alike = 0.0;        ///< share of them with the sign of the median, and half of it at least
        double cost = 0.0;         ///< of all ranges in the window
    };

    void decide(double now_s);
    void confirm(std::optional<AnchorDoubt> candidate, double now_s);
    std::optional<AnchorDoubt> candidate();
    std::optional<AnchorDoubt> judge(const Hypothesis& hypothesis) const;
    Hypothesis tryAnchor(int index);
    Fit fitted(bool mayMove) const;
    double capped(double residual, double variance) const;
    double costOf(const Report& report, const Eigen::Vector2d& place, int without) const;

    AnchorWatchSettings m_settings;
    std::vector<Report> m_reports; ///< a ring
    std::size_t m_next = 0;
    std::map<int, double> m_lastOfTag_s;
    double m_decided_s = 0.0;
    double m_now_s = 0.0;
    std::vector<Sight> m_sights; ///< of the hypothesis in work
    std::vector<double> m_residuals_m;

    std::optional<AnchorDoubt> m_candidate; ///< of the last decisions, in a row
    double m_candidateSince_s = 0.0;
    std::optional<AnchorDoubt> m_doubt;
};

} // namespace agv::estimation
