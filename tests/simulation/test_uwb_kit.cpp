// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated kit, heard through the decoder and the handshake that the console uses.
#include "simulation/uwb_kit.h"

#include "procedure/uwb_handshake.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace agv;
using namespace agv::protocol;
using namespace agv::simulation;
using namespace std::chrono_literals;

namespace {

constexpr Time start = Time{} + 50s;

std::vector<UwbAnchor> anchors(int count)
{
    PlantLayout plant;
    plant.width_m = 6.0;
    plant.height_m = 4.0;
    return defaultUwbAnchors(plant, count);
}

/// A kit and everything that was heard of it.
struct Bench {
    explicit Bench(const UwbKitSettings& settings) : kit(settings, start) {}

    /// Runs the kit in steps of 1 ms; `tags` as a function of the time since the start in s.
    template<typename Places>
    void run(Duration duration, Places tags)
    {
        for (const Time end = now + duration; now < end;) {
            now += 1ms;
            kit.step(now, tags(secondsFrom(now - start)));
            for (const UwbOutput& output : kit.take(now)) {
                bytes += output.bytes;
                stream.feed(output.bytes, output.at, [this](const TrekReport& report) {
                    reports.push_back(report);
                    const RangeSet set = reader.read(report);
                    ranges.insert(ranges.end(), set.begin(), set.end());
                });
            }
        }
    }
    void run(Duration duration, const std::vector<UwbTagPlace>& tags)
    {
        run(duration, [&tags](double) { return tags; });
    }
    std::size_t count(TrekLineKind kind) const
    {
        return static_cast<std::size_t>(
            std::ranges::count(reports, kind, [](const TrekReport& report) { return report.kind; }));
    }

    UwbKit kit;
    Time now = start;
    TrekStream stream;
    TrekRanges reader;
    std::string bytes;
    std::vector<TrekReport> reports;
    std::vector<RangeMeasurement> ranges;
};

double trueRange(const UwbAnchor& anchor, const UwbTagPlace& tag)
{
    return std::hypot(anchor.x - tag.x, anchor.y - tag.y, anchor.z - tag.z);
}

const UwbTagPlace standing{3, 2.0, 1.0, 0.4};

} // namespace

TEST(UwbKit, measuresTheTrueDistancesWhenItHasNoErrors)
{
    const auto places = anchors(4);
    Bench bench(idealUwbKitSettings(places));
    bench.run(2s, {standing});
    std::size_t checked = 0;
    for (const RangeMeasurement& range : bench.ranges) {
        if (range.kind != RangeKind::TagAnchor)
            continue;
        EXPECT_EQ(range.tag, 3);
        EXPECT_NEAR(range.range_m, trueRange(places[static_cast<std::size_t>(range.anchor)], standing),
                    0.5001e-3);
        ++checked;
    }
    EXPECT_GE(checked, 4U * 18U);
}

TEST(UwbKit, reportsRangesThatAreOnePeriodOld)
{
    for (const bool fast : {true, false}) {
        const auto places = anchors(4);
        UwbKitSettings settings = idealUwbKitSettings(places);
        settings.fastMode = fast;
        Bench bench(settings);
        bench.reader.setReportPeriod(fast ? 0.100 : 0.280);
        const auto driving = [](double t_s) {
            return std::vector<UwbTagPlace>{{0, 0.5 + 0.4 * t_s, 1.0 + 0.1 * t_s, 0.4}};
        };
        bench.run(8s, driving);
        for (const RangeMeasurement& range : bench.ranges) {
            if (range.kind != RangeKind::TagAnchor)
                continue;
            const double t_s = range.time_s - secondsFrom(start.time_since_epoch());
            EXPECT_NEAR(range.range_m,
                        trueRange(places[static_cast<std::size_t>(range.anchor)], driving(t_s)[0]), 2e-3)
                << "the age is taken off";
        }
    }
}

TEST(UwbKit, reportsEveryTagAtTheRateOfItsMode)
{
    std::vector<UwbTagPlace> eight;
    for (int tag = 0; tag < 8; ++tag)
        eight.push_back({tag, 1.0 + 0.4 * tag, 2.0, 0.4});
    for (const auto& [fast, expected] : {std::pair(true, 600.0), {false, 214.0}}) {
        UwbKitSettings settings = idealUwbKitSettings(anchors(4));
        settings.fastMode = fast;
        Bench bench(settings);
        bench.run(60s, eight);
        for (int tag = 0; tag < 8; ++tag) {
            EXPECT_NEAR(static_cast<double>(bench.reader.traffic(tag).reports), expected, 2.0);
            EXPECT_NEAR(bench.reader.traffic(tag).reportPeriod_s, fast ? 0.1 : 0.28, 0.006);
        }
        EXPECT_EQ(bench.stream.counts().damaged(), 0U);
    }
}

TEST(UwbKit, speaksEveryDialectInEveryFramingWithoutALostReport)
{
    for (const UwbDialect dialect : {UwbDialect::Trek, UwbDialect::TrekOld, UwbDialect::UlmFour,
                                     UwbDialect::UlmEight, UwbDialect::Esp32, UwbDialect::Imu}) {
        for (const UwbFraming framing :
             {UwbFraming::UsbTransfers, UwbFraming::UartBursts, UwbFraming::WholeLines}) {
            UwbKitSettings settings = idealUwbKitSettings(anchors(8));
            settings.dialect = dialect;
            settings.framing = framing;
            Bench bench(settings);
            bench.run(20s, {{0, 2.0, 1.0, 0.4}, {5, 3.0, 2.0, 0.4}});
            EXPECT_EQ(bench.stream.dialect().dialect(), dialect) << toText(dialect);
            EXPECT_EQ(bench.stream.dialect().contradictions(), 0U);
            EXPECT_EQ(bench.stream.counts().damaged(), 0U) << dropDetail(bench.stream.counts());
            for (const int tag : {0, 5}) {
                EXPECT_GE(bench.reader.traffic(tag).reports, 198U) << toText(dialect);
                EXPECT_EQ(bench.reader.traffic(tag).missed, 0U) << toText(dialect);
            }
        }
    }
}

TEST(UwbKit, reportsEightAnchorsInTheDialectsThatHaveThem)
{
    for (const UwbDialect dialect : {UwbDialect::UlmEight, UwbDialect::Imu}) {
        UwbKitSettings settings = idealUwbKitSettings(anchors(8));
        settings.dialect = dialect;
        Bench bench(settings);
        bench.run(1s, {standing});
        ASSERT_FALSE(bench.reports.empty());
        EXPECT_EQ(bench.reports.back().usable, 0xFF) << toText(dialect);
    }
}

TEST(UwbKit, hasNoiseAndBiasOfTheSizeThatWasAskedFor)
{
    const auto places = anchors(4);
    UwbKitSettings settings = idealUwbKitSettings(places);
    settings.model.noiseSd_m = 0.05;
    settings.model.bias_m = 0.18;
    Bench bench(settings);
    bench.run(120s, {standing});
    double sum = 0.0;
    double squares = 0.0;
    double n = 0.0;
    for (const RangeMeasurement& range : bench.ranges) {
        if (range.kind != RangeKind::TagAnchor)
            continue;
        const double error =
            range.range_m - trueRange(places[static_cast<std::size_t>(range.anchor)], standing);
        sum += error;
        squares += error * error;
        n += 1.0;
    }
    EXPECT_GT(n, 4000.0);
    EXPECT_NEAR(sum / n, 0.18, 0.005);
    EXPECT_NEAR(std::sqrt(squares / n - sum / n * sum / n), 0.05, 0.003);
}

TEST(UwbKit, hasBurstsInWhichRangesAreTooLong)
{
    const auto places = anchors(4);
    UwbKitSettings settings = idealUwbKitSettings(places);
    settings.model.nlosPerMinute = 6.0;
    Bench bench(settings);
    bench.run(300s, {standing});
    std::size_t clear = 0;
    std::size_t blocked = 0;
    for (const RangeMeasurement& range : bench.ranges) {
        if (range.kind != RangeKind::TagAnchor)
            continue;
        const double error =
            range.range_m - trueRange(places[static_cast<std::size_t>(range.anchor)], standing);
        EXPECT_TRUE(std::abs(error) < 1e-3 || (error > 0.299 && error < 0.901)) << error;
        ++(error > 0.1 ? blocked : clear);
    }
    const double share = static_cast<double>(blocked) / static_cast<double>(blocked + clear);
    EXPECT_GT(share, 0.08) << "2 s of about 12 s";
    EXPECT_LT(share, 0.28);
}

TEST(UwbKit, leavesOutAnAnchorThatIsMissingAndComesBackWithIt)
{
    for (const UwbDialect dialect : {UwbDialect::Trek, UwbDialect::UlmFour, UwbDialect::Imu}) {
        UwbKitSettings settings = idealUwbKitSettings(anchors(4));
        settings.dialect = dialect;
        Bench bench(settings);
        bench.kit.setAnchorMissing(1, true);
        bench.run(3s, {standing});
        ASSERT_FALSE(bench.reports.empty());
        for (const TrekReport& report : bench.reports) {
            if (report.kind == TrekLineKind::Corrected || report.kind == TrekLineKind::Imu) {
                EXPECT_EQ(report.usable, 0x0D) << toText(dialect);
            }
        }
        bench.kit.restore(bench.now);
        bench.reports.clear();
        bench.run(1s, {standing});
        EXPECT_EQ(bench.reports.back().usable & 0x0EU, 0x0EU);
    }
}

TEST(UwbKit, showsLostExchangesAsGapsOfRseq)
{
    UwbKitSettings settings = idealUwbKitSettings(anchors(4));
    settings.model.lostRate = 0.1;
    Bench bench(settings);
    bench.run(100s, {standing});
    const TagTraffic& traffic = bench.reader.traffic(3);
    EXPECT_NEAR(static_cast<double>(traffic.missed), 100.0, 30.0);
    EXPECT_NEAR(static_cast<double>(traffic.missed + traffic.reports), 999.0, 3.0);
}

TEST(UwbKit, answersTheHandshakeAndStopsItsRawReports)
{
    Bench bench(idealUwbKitSettings(anchors(4)));
    procedure::UwbHandshake handshake;
    handshake.opened(true, bench.now);
    bench.run(1s, {standing});
    EXPECT_GT(bench.count(TrekLineKind::Raw), 5U);
    ASSERT_EQ(handshake.bytes(bench.bytes, bench.stream.dialect().dialect(), bench.now),
              procedure::UwbHandshakeAction::SendRequest);

    bench.kit.receive(procedure::UwbHandshake::request, bench.now);
    bench.bytes.clear();
    bench.reports.clear();
    const Time sent = bench.now;
    bench.run(990ms, {standing});
    EXPECT_TRUE(bench.reports.empty()) << "silent for a second";
    handshake.bytes(bench.bytes, UwbDialect::Trek, bench.now);
    ASSERT_TRUE(handshake.unit());
    EXPECT_EQ(handshake.unit()->version, "Ver.2.25mx TREK");
    EXPECT_EQ(handshake.unit()->configuration, (UwbConfiguration{true, 2, UwbRole::Anchor, 0}));
    EXPECT_TRUE(handshake.isSilenceExpected(sent + 990ms));

    bench.run(2s, {standing});
    EXPECT_GT(bench.count(TrekLineKind::Corrected), 15U);
    EXPECT_EQ(bench.count(TrekLineKind::Raw), 0U);
    EXPECT_EQ(bench.stream.counts().damaged(), 0U);
}

TEST(UwbKit, ofACloneAnswersNothingAndTellsThatItWasSpokenTo)
{
    UwbKitSettings settings = idealUwbKitSettings(anchors(4));
    settings.dialect = UwbDialect::UlmFour;
    Bench bench(settings);
    bench.run(1s, {standing});
    EXPECT_EQ(bench.kit.receivedBytes(), 0U);
    bench.kit.receive("decA$", bench.now);
    const std::size_t before = bench.reports.size();
    bench.run(1s, {standing});
    EXPECT_GE(bench.reports.size(), before + 9);
    EXPECT_EQ(bench.bytes.find("nVer"), std::string::npos);
    EXPECT_EQ(bench.kit.receivedBytes(), 5U);
}

TEST(UwbKit, comesBackAHundredTimesAfterBeingUnplugged)
{
    Bench bench(idealUwbKitSettings(anchors(4)));
    bench.run(1s, {standing});
    for (int i = 0; i < 100; ++i) {
        bench.kit.unplug(500ms, bench.now);
        EXPECT_FALSE(bench.kit.isPlugged(bench.now));
        bench.stream.reset();
        bench.reader.reset();
        bench.reports.clear();
        bench.run(490ms, {standing});
        ASSERT_TRUE(bench.reports.empty());
        bench.run(1s, {standing});
        ASSERT_GE(bench.count(TrekLineKind::Corrected), 9U);
        ASSERT_LT(bench.reports.front().deviceTime_ms, 200) << "its clock begins anew";
        bench.run(Duration((i * 37 % 100) * 1ms), {standing}); // unplugged anywhere in a line
    }
    EXPECT_EQ(bench.stream.counts().damaged(), 0U);
}

TEST(UwbKit, printsGarbageThatTheDecoderCounts)
{
    Bench bench(idealUwbKitSettings(anchors(4)));
    for (int i = 0; i < 50; ++i) {
        bench.kit.printGarbage(20);
        bench.run(100ms, {standing});
    }
    EXPECT_GE(bench.stream.counts().damaged(), 40U);
    EXPECT_GE(bench.reader.traffic(3).reports, 48U);
    EXPECT_EQ(bench.reader.traffic(3).missed, 0U);
}

TEST(UwbKit, givesTheSameBytesForTheSameSeed)
{
    const auto bytesOf = [](std::uint64_t seed) {
        UwbKitSettings settings;
        settings.seed = seed;
        settings.anchors = anchors(4);
        Bench bench(settings);
        bench.run(20s, {standing, {4, 1.0, 1.0, 0.4}});
        return bench.bytes;
    };
    EXPECT_EQ(bytesOf(1), bytesOf(1));
    EXPECT_NE(bytesOf(1), bytesOf(2));
}

TEST(UwbKit, beginsAnewWithATagThatWasSwitchedOff)
{
    Bench bench(idealUwbKitSettings(anchors(4)));
    bench.run(2s, {standing});
    bench.run(10s, std::vector<UwbTagPlace>{});
    bench.reports.clear();
    bench.run(1s, {standing});
    EXPECT_LE(bench.count(TrekLineKind::Corrected), 10U) << "nothing is made up for the time between";
    EXPECT_GE(bench.count(TrekLineKind::Corrected), 8U);
}
