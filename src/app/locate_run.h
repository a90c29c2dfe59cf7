// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/uwb_calibration.h"
#include "app/uwb_files.h"
#include "app/uwb_reports.h"
#include "app/uwb_truth.h"
#include "core/geometry.h"
#include "estimation/uwb/locator.h"
#include "recording/odometry_table.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace agv::app {

/// A position from floor tags.
struct FloorFix {
    double time_s = 0.0;
    Point2 position;
};

/// What a vehicle knows besides its ranges; both in the order of time.
struct VehicleData {
    std::vector<recording::OdometryRow> odometry;
    std::vector<FloorFix> floorFixes;
    std::optional<Pose2> startPose;
    std::optional<double> startHeading; ///< rad
    std::optional<Point2> mount;        ///< of the UWB tag in the vehicle frame, m, whatever its id
    std::map<int, Point2> mounts;       ///< by id of the tag, where mount is empty

    Point2 mountOf(int tag) const;
};

/// What a method made of one report.
struct ReportFix {
    estimation::FixStatus status = estimation::FixStatus::TooFewRanges;
    Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< m, means nothing unless the status is Ok
    Eigen::Vector3d sd = Eigen::Vector3d::Zero();       ///< m, 0: not known
    std::optional<double> heading;                      ///< rad
    int rejected = 0;                                   ///< ranges that were held for blocked or wrong

    bool ok() const { return status == estimation::FixStatus::Ok; }
};

/// The ranges of a file as the methods take them: corrected, with the places of their anchors.
class PreparedRanges {
public:
    /// `calibration` may be null. Anchors that are not in the list and pairs that were not calibrated are
    /// noted.
    static Result<PreparedRanges> make(const recording::RangeTable& table, ReportList list,
                                       const AnchorSet& anchors, const UwbCalibration* calibration,
                                       const std::string& path);

    /// Moments without ranges, for what floor tags and wheels say alone.
    static PreparedRanges none(ReportList list);

    const ReportList& list() const { return m_list; }
    std::span<const estimation::AnchorRange> of(std::size_t report) const
    {
        return std::span(m_ranges).subspan(m_first[report], m_first[report + 1] - m_first[report]);
    }
    const std::map<int, std::size_t>& unknownAnchors() const { return m_unknown; } ///< id -> ranges
    std::size_t uncalibrated() const { return m_uncalibrated; }
    std::size_t usedRanges() const { return m_ranges.size(); }

private:
    ReportList m_list;
    std::vector<estimation::AnchorRange> m_ranges;
    std::vector<std::size_t> m_first; ///< of each report, and the end
    std::map<int, std::size_t> m_unknown;
    std::size_t m_uncalibrated = 0;
};

struct MethodSettings {
    std::vector<Eigen::Vector3d> anchors;
    std::vector<double> heights_m; ///< of the tag, by track
    std::uint64_t seed = 1;
};

/// For tags that stand and tags that move: on each track `static` where the tag stays where it is, else
/// `ekf-los`. A tag stands when hardly any range of the track is too short for the place where `static` has
/// it in the end: hidden anchors make ranges longer, motion makes some shorter.
inline constexpr std::string_view automaticMethod = "auto";

/// Runs a method, or automaticMethod, over every report, a filter of its own for each track. BadInput when it
/// cannot be made.
Result<std::vector<ReportFix>> runMethod(std::string_view method, const PreparedRanges& ranges,
                                         const MethodSettings& settings, const VehicleData* vehicle);

} // namespace agv::app
