// SPDX-License-Identifier: GPL-3.0-or-later
// Genuine lines from the recordings beside the project; left out, and said so, where they are not there.
#include "core/text_file.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_samples.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace agv;
using namespace agv::protocol;
namespace fs = std::filesystem;

namespace {

class RecordedTrekLines : public testing::Test {
protected:
    void SetUp() override
    {
        if (!fs::exists(m_folder))
            GTEST_SKIP() << "the recordings are not here: " << m_folder;
    }
    std::string content(const char* name) const
    {
        auto text = readTextFile(m_folder / name, std::size_t{1} << 20U);
        EXPECT_TRUE(text.has_value()) << name;
        return text.value_or(std::string());
    }
    fs::path m_folder = fs::path(AGV_RECORDINGS) / "trek_lines";
};

std::size_t occurrences(std::string_view text, std::string_view wanted)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(wanted); at != std::string_view::npos; at = text.find(wanted, at + 1))
        ++count;
    return count;
}

std::size_t linesBeginning(std::string_view text, std::string_view begin)
{
    return (text.starts_with(begin) ? 1U : 0U) + occurrences(text, "\n" + std::string(begin));
}

} // namespace

TEST_F(RecordedTrekLines, ofAGenuineKitAreAllRead)
{
    const std::string text = content("trek1000_sample.txt");
    const samples::Heard heard = samples::hear(text);
    EXPECT_EQ(heard.dialect, UwbDialect::Trek);
    const std::size_t lines =
        linesBeginning(text, "mc ") + linesBeginning(text, "mr ") + linesBeginning(text, "ma ");
    EXPECT_EQ(heard.reports.size(), lines - 1) << "one line is cut";
    EXPECT_EQ(heard.counts.damaged(), 1U);
    EXPECT_EQ(heard.counts.skipped(), 0U);
    for (const TrekReport& report : heard.reports)
        EXPECT_EQ(report.usable, report.mask);
}

TEST_F(RecordedTrekLines, ofACloneAreAllReadWithAllTheirRanges)
{
    for (const char* const name : {"ulm_clone_room_b.mc.txt", "ulm_clone_wall_a.mc.txt"}) {
        const std::string text = content(name);
        TrekStream stream;
        TrekRanges ranges(TrekRanges::TimeBase::DeviceClock);
        std::size_t reports = 0;
        std::size_t usable = 0;
        stream.feed(text, Time{}, [&](const TrekReport& report) {
            ++reports;
            usable += ranges.read(report).size();
        });
        EXPECT_EQ(stream.dialect().dialect(), UwbDialect::UlmFour) << name;
        EXPECT_EQ(reports, linesBeginning(text, "mc ")) << name;
        EXPECT_EQ(stream.counts().skipped(), linesBeginning(text, "$NKT0")) << name;
        EXPECT_EQ(stream.counts().damaged(), 0U) << name;
        EXPECT_EQ(usable, 4 * reports - occurrences(text, "ffffffff")) << name;
        EXPECT_NEAR(ranges.traffic(0).reportPeriod_s, 0.112, 0.002) << name << ": its time is decimal";
    }
}

TEST_F(RecordedTrekLines, comeThroughEveryFraming)
{
    for (const char* const name : {"trek1000_sample.txt", "ulm_clone_wall_a.mc.txt"}) {
        const std::string text = content(name);
        const samples::Heard whole = samples::hear(text);
        for (const std::size_t size : {1U, 16U, 63U, 64U, 65U, 66U, 130U, 1000U})
            EXPECT_EQ(samples::hearInBursts(text, size), whole) << name << " in bursts of " << size;
    }
}
