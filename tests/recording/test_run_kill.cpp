// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/run_support.h"

#include <chrono>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace agv::recording::test {
namespace {

constexpr int rowsPerBatch = 20;

/// Writes batch after batch and tells of each that is kept; never returns.
[[noreturn]] void writeForEver(const std::filesystem::path& runs, int tellTo)
{
    auto writer = newRun(runs);
    SplitMix64 random(1);
    for (std::int32_t batch = 0; writer; ++batch) {
        if (::write(tellTo, &batch, sizeof batch) != sizeof batch)
            break;
        if (!writer->append(
                randomBatch(random, startTime + batch * std::chrono::milliseconds(500), rowsPerBatch)))
            break;
    }
    ::_exit(1);
}

/// The batches that the writer said are kept; `kept` when it says nothing more.
std::int32_t keptBatches(int from, std::int32_t kept)
{
    std::int32_t number = 0;
    while (::read(from, &number, sizeof number) == sizeof number)
        kept = number;
    return kept;
}

} // namespace

// The console hands a batch over every quarter of a second; so what a kill costs is at most what was not yet
// handed over, provided that every batch that was written stays.
TEST(RunKill, aProcessKilledAtAnyMomentLosesNoBatchThatWasWrittenAndTheRunOpens)
{
    SplitMix64 random(20);
    int opened = 0;
    std::int64_t batches = 0;
    for (int i = 0; i < 200; ++i) {
        const TemporaryFolder runs;
        int ends[2];
        ASSERT_EQ(::pipe(ends), 0);
        const pid_t writer = ::fork();
        ASSERT_GE(writer, 0);
        if (writer == 0) {
            ::close(ends[0]);
            writeForEver(runs.path(), ends[1]);
        }
        ::close(ends[1]);
        // Every second one is killed in the midst of the work, however slow the machine; the others at any
        // moment.
        std::int32_t first = -1;
        if (i % 2 == 1) {
            ASSERT_EQ(::read(ends[0], &first, sizeof first), static_cast<ssize_t>(sizeof first));
        }
        ::usleep(static_cast<useconds_t>(below(random, 60'000)));
        ::kill(writer, SIGKILL);
        int status = 0;
        ASSERT_EQ(::waitpid(writer, &status, 0), writer);
        ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << "the writer ended by itself";
        const std::int32_t kept = keptBatches(ends[0], first);
        ::close(ends[0]);
        if (kept < 0)
            continue; // there is no run yet
        auto reader = RunReader::open(runs.path() / runName(startUtc_us / 1000));
        ASSERT_TRUE(reader) << reader.error().detail;
        std::size_t rows = 0;
        for (std::size_t table = 0; table < runTableCount; ++table) {
            const auto read = rowsOf(*reader, table);
            ASSERT_TRUE(read) << read.error().detail;
            rows += read->size();
        }
        const auto chunks = chunksOf(*reader);
        ASSERT_TRUE(chunks) << chunks.error().detail;
        const auto least = static_cast<std::size_t>(kept) * rowsPerBatch;
        EXPECT_TRUE(rows == least || rows == least + rowsPerBatch) << rows << " of " << least;
        EXPECT_EQ(chunks->size(), rows);
        ++opened;
        batches += kept;
    }
    EXPECT_GE(opened, 100);
    EXPECT_GT(batches, 0);
}

} // namespace agv::recording::test
