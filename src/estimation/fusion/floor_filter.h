// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/random.h"
#include "estimation/measurement_record.h"
#include "estimation/uwb/anchor_range.h"

#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

namespace agv::estimation {

struct FloorFilterSettings {
    int particles = 3000;        ///< 16 or more; with 1000 the wheels' errors are at times learnt wrongly
    double track_m = 0.286;      ///< distance of the wheels
    Point2 antenna{-0.100, 0.0}; ///< vehicle frame, m
    double wheelScaleSd = 0.05;  ///< unknown diameter of both wheels, relative
    double wheelDifferenceSd = 0.015; ///< unknown difference between them, relative
    double wheelNoise = 0.03;         ///< of each reported speed, relative
    double placeNoise_m = 1e-4;       ///< per step
    double headingNoise = 8.7e-4;     ///< rad per step
    double distanceSd_m = 0.004;      ///< blur of the RSSI table: tags, antenna, edges
    double offByOne = 0.4;            ///< probability of an RSSI one too high or low
    double outlier = 5e-3;            ///< weight of a read that means nothing
    double rangeSd_m = 0.12;          ///< of a range in sight: noise, and what calibration leaves
    double obstructed = 0.1;          ///< share of the ranges that say nothing
    std::uint64_t seed = 1;
};

/// A floor tag read while driving.
struct FloorRead {
    TagUid uid;
    int rssi = 0; ///< 0..7
};

/// Pose of a vehicle that drives over a floor of RFID tags: particle filter over (x, y, heading, diameter
/// error of the wheels, difference between them), moved by the wheel speeds, weighed by the tags read. Given
/// that the reader reads some tag, it is tag i with RSSI r with probability P(r | d_i) / sum over tags and
/// RSSIs: how often tags are missed drops out. UWB ranges help where no floor tags are. Must be started by
/// the pose of the initialisation turn.
/// Nothing allocates after construction but for growing to the number of tags in reach; the same seed and
/// input give the same track.
class FloorFilter {
public:
    /// Tags of the floor and the RSSI table of the reader (problemOf(table) must be empty).
    FloorFilter(const TagMap& tags, const RssiTable& table, const FloorFilterSettings& settings = {});

    void start(const Pose2& pose, const PoseCovariance& covariance);
    bool started() const { return m_started; }
    /// Moves by the wheel speeds (m/s) that held for dt_s.
    void predict(double left_m_s, double right_m_s, double dt_s);
    /// The wheels may have gone farther than predict() was told, or less: by these sds, m.
    void slip(double left_m, double right_m);
    /// Reads since the last step. A tag that is not on the floor plan is recorded as rejected.
    const MeasurementRecords& update(std::span<const FloorRead> reads);
    /// Ranges of a UWB tag at `tag` (vehicle frame, m), `height_m` above the floor. `share`, 0 to 1: how much
    /// of them is news, since the errors of ranges hardly change from one report to the next.
    const MeasurementRecords& update(AnchorRanges ranges, Point2 tag, double height_m, double share);
    /// Of a read of the tag at this place: its squared distance from the antenna over what the reach of the
    /// antenna and the uncertainty of the pose allow; above 1 the read contradicts the pose.
    double testRatio(Point2 tag) const;

    Pose2 pose() const { return m_pose; }
    const PoseCovariance& covariance() const { return m_covariance; }
    /// The reads contradict the pose: most of the last ones came from tags out of reach. A new initialisation
    /// turn is needed.
    bool lost() const { return m_plausible < 0.5; }

private:
    struct Table {
        std::vector<float> logRead; ///< [rssi][cell]: log P(rssi | d)
        std::vector<float> read;    ///< [cell]: P(any rssi | d)
        int cells = 0;
    };
    struct Cloud {
        using Vector = Eigen::Matrix<double, 5, 1>;
        using Matrix = Eigen::Matrix<double, 5, 5>;
        Vector mean;
        Matrix root; ///< lower triangular
    };
    void fillTable(const RssiTable& table);
    int cellOf(float distance_m) const;
    void gatherCandidates(Point2 around, double reach);
    void place(Point2 offset);
    double readVariance() const;
    void addReadable();
    MeasurementRecord weigh(Point2 tag, int rssi);
    MeasurementRecord weigh(const AnchorRange& range, Point2 tag, double height_m, double share);
    void normalise();
    void summarise();
    void resampleWhenNeeded();
    Cloud cloudNow() const;
    void drawByWeight();

    FloorFilterSettings m_settings;
    TagMap m_tags;
    std::vector<Point2> m_tagsByX;
    Table m_table;
    SplitMix64 m_random;
    std::vector<double> m_x, m_y, m_heading, m_scale, m_difference, m_weight, m_log, m_spare;
    std::vector<float> m_placedX, m_placedY, m_readable; ///< antenna or UWB tag of each particle
    std::vector<Point2> m_candidates;
    Pose2 m_pose;
    PoseCovariance m_covariance{};
    MeasurementRecords m_records;
    double m_plausible = 1.0;
    bool m_started = false;
};

} // namespace agv::estimation
