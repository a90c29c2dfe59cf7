// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/uwb_reports.h"

#include <gtest/gtest.h>

namespace agv::app {
namespace {

TEST(UwbReports, BelongTogetherBySequenceAndNotByWrongTimes)
{
    recording::RangeTable table;
    table.extraColumns = {"point", "label", "count"};
    const auto add = [&](double t, int anchor, int sequence, const char* point, const char* label,
                         int count) {
        table.ranges.push_back({.time_s = t, .range_m = 1.0, .anchor = anchor, .sequence = sequence});
        table.extras.insert(table.extras.end(), {point, label, std::to_string(count)});
    };
    for (int k = 0; k < 6; ++k) {
        const char* const point = k < 3 ? "a" : "b";
        add(k, 0, 7 + k, point, "0", k);
        add(k + 0.5, 1, 7 + k, point, "1", k);
        add(k, 2, 7 + k, point, "0", k);
    }
    const ReportList list = groupReports(table, {});
    ASSERT_EQ(list.reports.size(), 6U);
    EXPECT_EQ(list.groupColumns, (std::vector<std::size_t>{0})) << "neither labels of ranges nor counts";
    EXPECT_EQ(list.tracks, 2U);
    EXPECT_DOUBLE_EQ(list.reports[2].time_s, 2.0);
    EXPECT_EQ(list.reports[2].rows.size(), 3U);
}

TEST(UwbReports, BeginANewTrackWhereTimeStepsBack)
{
    recording::RangeTable table;
    for (const double t : {1.0, 2.0, 1.5, 2.5, 0.5})
        table.ranges.push_back({.time_s = t, .range_m = 1.0});
    const ReportList list = groupReports(table, {});
    EXPECT_EQ(list.reports.size(), 5U);
    EXPECT_EQ(list.tracks, 2U);
    EXPECT_EQ(list.reports[3].track, list.reports[0].track) << "half a second is no new recording";
}

} // namespace
} // namespace agv::app
