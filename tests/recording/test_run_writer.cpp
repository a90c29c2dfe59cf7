// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/run_support.h"

#include "core/plant_file.h"
#include "recording/raw_block.h"

#include <csignal>
#include <fstream>
#include <map>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace agv::recording::test {
namespace {

using namespace std::chrono_literals;

RunBatch events(int first, int count, Duration since)
{
    RunBatch batch;
    for (int i = first; i < first + count; ++i)
        batch.rows.push_back(
            EventRow{startTime + since, {0, EventLevel::Info, "Console", std::to_string(i)}});
    batch.clocks = clocksAt(since);
    return batch;
}

constexpr std::size_t eventTable = 9;

std::size_t eventsIn(const std::filesystem::path& run)
{
    auto reader = RunReader::open(run);
    EXPECT_TRUE(reader) << reader.error().detail;
    const auto rows = reader ? rowsOf(*reader, eventTable) : Result<std::vector<StoredRow>>();
    EXPECT_TRUE(rows);
    return rows ? rows->size() : 0;
}

/// As a user who is not almighty; root is not kept out of anything.
class AsNobody {
public:
    AsNobody()
    {
        if (::geteuid() == 0)
            m_isRoot = ::seteuid(65534) == 0;
    }
    ~AsNobody()
    {
        if (m_isRoot)
            static_cast<void>(::seteuid(0));
    }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;

private:
    bool m_isRoot = false;
};

} // namespace

TEST(RunWriter, rowsOfEveryKindReadBackAsTheyWereWrittenAndInTheirOrder)
{
    const TemporaryFolder runs;
    SplitMix64 random(7);
    std::array<std::vector<StoredRow>, runTableCount> written;
    auto writer = newRun(runs.path());
    ASSERT_TRUE(writer) << writer.error().detail;
    for (int k = 0; k < 20; ++k) {
        const RunBatch batch = randomBatch(random, startTime + k * 500ms, 200);
        for (const RunRow& row : batch.rows)
            written[row.index()].push_back(stored(row));
        ASSERT_TRUE(writer->append(batch));
    }
    ASSERT_TRUE(writer->finish(startUtc_us / 1000 + 10'000));

    auto reader = RunReader::open(writer->folder());
    ASSERT_TRUE(reader) << reader.error().detail;
    for (std::size_t table = 0; table < runTableCount; ++table) {
        EXPECT_FALSE(written[table].empty());
        EXPECT_EQ(rowsOf(*reader, table), written[table]) << runTables()[table].name;
        EXPECT_EQ(reader->countRows(table), written[table].size());
    }
}

TEST(RunWriter, everyByteOfEveryLinkReadsBackWithItsTimeInTheOrderOfArrival)
{
    const TemporaryFolder runs;
    SplitMix64 random(8);
    std::vector<RunChunk> written;
    auto writer = newRun(runs.path());
    ASSERT_TRUE(writer);
    for (int k = 0; k < 50; ++k) {
        const RunBatch batch = randomBatch(random, startTime + k * 500ms, 100);
        for (RunChunk chunk : batch.chunks) {
            chunk.time = Time{} + (chunk.time - startTime);
            written.push_back(chunk);
        }
        ASSERT_TRUE(writer->append(batch));
    }
    auto reader = RunReader::open(writer->folder()); // while it is being written
    ASSERT_TRUE(reader);
    EXPECT_EQ(chunksOf(*reader), written);
}

TEST(RunWriter, aRunSaysWhatItIsAndCarriesItsPlant)
{
    const TemporaryFolder runs;
    auto writer = newRun(runs.path());
    ASSERT_TRUE(writer);
    EXPECT_EQ(writer->folder().filename(), "20260317T153005Z");
    auto running = RunReader::open(writer->folder());
    ASSERT_TRUE(running);
    EXPECT_FALSE(running->info().ended_utc_ms.has_value());
    ASSERT_TRUE(writer->finish(startUtc_us / 1000 + 60'000));
    auto ended = RunReader::open(writer->folder());
    ASSERT_TRUE(ended);
    EXPECT_EQ(ended->info().ended_utc_ms, startUtc_us / 1000 + 60'000);
    EXPECT_EQ(ended->info().started_utc_ms, startUtc_us / 1000);
    EXPECT_EQ(ended->info().note, operatorsRun().note);
    EXPECT_EQ(ended->info().agvs, operatorsRun().agvs);
    EXPECT_EQ(ended->plant(), smallPlant());
}

TEST(RunWriter, aFullDiskEndsTheRecordingWithItsReasonAndKeepsEverythingBefore)
{
    const TemporaryFolder runs;
    auto writer = newRun(runs.path());
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->append(events(0, 100, 0s)));
    ASSERT_TRUE(writer->limitPages(40));
    int batches = 1;
    Result<void> result;
    for (; result && batches < 1000; ++batches)
        result = writer->append(events(100 * batches, 100, batches * 500ms));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Io);
    EXPECT_NE(result.error().detail.find("the disk is full"), std::string::npos) << result.error().detail;
    EXPECT_EQ(eventsIn(writer->folder()), 100U * (static_cast<unsigned>(batches) - 1));
}

TEST(RunWriter, aFileThatMustNotGrowEndsTheRecordingWithItsReasonAndKeepsEverythingBefore)
{
    const TemporaryFolder runs;
    auto writer = newRun(runs.path());
    ASSERT_TRUE(writer);
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit little{200'000, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &little), 0);
    int batches = 0;
    Result<void> result;
    for (; result && batches < 1000; ++batches)
        result = writer->append(events(100 * batches, 100, batches * 500ms));
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Io);
    EXPECT_GT(batches, 1);
    EXPECT_EQ(eventsIn(writer->folder()), 100U * (static_cast<unsigned>(batches) - 1));
}

TEST(RunWriter, aRemovedFolderEndsTheRecordingWithItsReason)
{
    const TemporaryFolder runs;
    auto writer = newRun(runs.path());
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->append(events(0, 1, 0s)));
    std::filesystem::remove_all(writer->folder());
    for (const Result<void>& result :
         {writer->append(events(1, 1, 1s)), writer->forget(startTime), writer->finish(0)}) {
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::NotFound);
        EXPECT_NE(result.error().detail.find("removed"), std::string::npos);
    }
    EXPECT_FALSE(std::filesystem::exists(writer->folder()));
}

TEST(RunWriter, aFolderThatMustNotBeWrittenIsNamed)
{
    const AsNobody nobody;
    const TemporaryFolder runs;
    ASSERT_EQ(::chmod(runs.path().c_str(), 0555), 0);
    const auto writer = newRun(runs.path());
    ASSERT_EQ(::chmod(runs.path().c_str(), 0755), 0);
    ASSERT_FALSE(writer);
    EXPECT_EQ(writer.error().code, ErrorCode::Permission);
    EXPECT_NE(writer.error().detail.find(runs.path().string()), std::string::npos);
}

TEST(RunWriter, aFileInPlaceOfTheFolderIsNamed)
{
    const TemporaryFolder runs;
    std::ofstream(runs.path() / "file") << "x";
    const auto writer = newRun(runs.path() / "file");
    ASSERT_FALSE(writer);
    EXPECT_NE(writer.error().detail.find("choose another folder"), std::string::npos);
}

TEST(RunWriter, twoConsolesNeverWriteOneRun)
{
    const TemporaryFolder runs;
    auto first = newRun(runs.path());
    auto second = newRun(runs.path());
    ASSERT_TRUE(first && second);
    EXPECT_EQ(second->folder().filename(), "20260317T153005Z-2");
    const auto stolen = RunLock::take(first->folder());
    ASSERT_FALSE(stolen);
    EXPECT_EQ(stolen.error().code, ErrorCode::InUse);
    const auto folder = first->folder();
    {
        const RunWriter gone = std::move(*first);
    }
    EXPECT_TRUE(RunLock::take(folder));
}

TEST(RunWriter, aClockThatJumpsReordersNothingAndTheWallClockOfEachRowIsThatOfItsMoment)
{
    const TemporaryFolder runs;
    auto writer = newRun(runs.path());
    ASSERT_TRUE(writer);
    const std::int64_t jumps_us[] = {0, -3'600'000'000, 7'200'000'000, 0};
    for (int k = 0; k < 4; ++k) {
        RunBatch batch = events(k, 1, k * 10s + 100ms);
        batch.clocks = clocksAt(k * 10s);
        batch.clocks.utc_us += jumps_us[k];
        ASSERT_TRUE(writer->append(batch));
    }
    auto reader = RunReader::open(writer->folder());
    ASSERT_TRUE(reader);
    const auto rows = rowsOf(*reader, eventTable);
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 4U);
    for (int k = 0; k < 4; ++k) {
        const StoredRow& row = (*rows)[static_cast<std::size_t>(k)];
        EXPECT_EQ(row.t_ns, Duration(k * 10s + 100ms).count());
        EXPECT_EQ(reader->utcAt_us(row.t_ns), startUtc_us + jumps_us[k] + (k * 10'000 + 100) * 1000);
    }
}

TEST(RunWriter, aRunThatForgetsDoesNotGrow)
{
    const TemporaryFolder runs;
    auto writer = newRun(runs.path());
    ASSERT_TRUE(writer);
    SplitMix64 random(3);
    std::uint64_t bytesAfterAMinute = 0;
    for (int k = 0; k < 600; ++k) {
        ASSERT_TRUE(writer->append(randomBatch(random, startTime + k * 500ms, 100)));
        if (k % 20 == 19) {
            ASSERT_TRUE(writer->forget(startTime + k * 500ms - 30s));
        }
        if (k == 180)
            bytesAfterAMinute = writer->bytesOnDisk();
    }
    EXPECT_LT(writer->bytesOnDisk(), bytesAfterAMinute * 3 / 2);
    auto reader = RunReader::open(writer->folder());
    ASSERT_TRUE(reader);
    for (std::size_t table = 0; table < runTableCount; ++table) {
        const auto rows = rowsOf(*reader, table);
        ASSERT_TRUE(rows);
        ASSERT_FALSE(rows->empty());
        EXPECT_GE(rows->front().t_ns, Duration(269s).count());
    }
}

TEST(RunWriter, whatHappenedJustNowIsKeptAsARunOfItsOwn)
{
    const TemporaryFolder runs;
    auto ring = RunWriter::create(runs.path(), operatorsRun(), smallPlant(), clocksAt({}), "recent");
    ASSERT_TRUE(ring);
    EXPECT_EQ(ring->folder().filename(), "recent");
    SplitMix64 random(4);
    std::vector<StoredRow> late;
    for (int k = 0; k < 60; ++k) {
        const RunBatch batch = randomBatch(random, startTime + k * 500ms, 50);
        ASSERT_TRUE(ring->append(batch));
        for (const RunRow& row : batch.rows) {
            StoredRow one = stored(row);
            one.t_ns -= Duration(20s).count();
            if (row.index() == eventTable && one.t_ns >= 0)
                late.push_back(one);
        }
    }
    RunInfo info = operatorsRun();
    info.startedBy = "kept";
    const auto kept = ring->keep(runs.path(), info, smallPlant(), startTime + 20s);
    ASSERT_TRUE(kept) << kept.error().detail;
    ASSERT_TRUE(ring->append(randomBatch(random, startTime + 30s, 50))); // it goes on

    auto reader = RunReader::open(*kept);
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->info().startedBy, "kept");
    EXPECT_EQ(reader->info().started_utc_ms, startUtc_us / 1000 + 20'000);
    EXPECT_EQ(rowsOf(*reader, eventTable), late);
    EXPECT_EQ(reader->utcAt_us(0), startUtc_us + 20'000'000);
    const auto chunks = chunksOf(*reader);
    ASSERT_TRUE(chunks);
    EXPECT_GT(chunks->size(), 900U);
}

TEST(RawBlock, damagedBlocksAreErrors)
{
    const RunChunk one{startTime, "uwb", "mc 0f 00000663\r\n"};
    const RunChunk two{startTime + 3ms, "uwb", std::string(300, 'x')};
    const RunChunk* const chunks[] = {&one, &two};
    const std::string packed = packChunks(chunks);
    const auto whole = unpackChunks(packed, startTime, "uwb");
    ASSERT_TRUE(whole);
    EXPECT_EQ(*whole, (std::vector{one, two}));
    for (std::size_t length = 0; length < packed.size(); ++length)
        EXPECT_FALSE(unpackChunks(packed.substr(0, length), startTime, "uwb")) << length;
    std::string huge = packed;
    huge[3] = '\x7f'; // it claims two gigabytes
    EXPECT_FALSE(unpackChunks(huge, startTime, "uwb"));
}

} // namespace agv::recording::test
