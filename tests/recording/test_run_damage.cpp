// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/run_support.h"

#include <fstream>
#include <sstream>

namespace agv::recording::test {
namespace {

std::string contents(const std::filesystem::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

void put(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

/// Reads everything; the reason when that fails.
std::string troubleWith(const std::filesystem::path& run)
{
    auto reader = RunReader::open(run);
    if (!reader)
        return reader.error().detail;
    for (std::size_t table = 0; table < runTableCount; ++table) {
        if (const auto rows = rowsOf(*reader, table); !rows)
            return rows.error().detail;
    }
    const auto chunks = chunksOf(*reader);
    return chunks ? std::string() : chunks.error().detail;
}

class RunDamage : public testing::Test {
protected:
    void SetUp() override
    {
        auto writer = newRun(runs.path());
        ASSERT_TRUE(writer);
        SplitMix64 random(2);
        for (int k = 0; k < 8; ++k)
            ASSERT_TRUE(
                writer->append(randomBatch(random, startTime + k * std::chrono::milliseconds(500), 100)));
        ASSERT_TRUE(writer->finish(0));
        run = writer->folder();
        database = run / runDatabaseFile;
        whole = contents(database);
        ASSERT_EQ(troubleWith(run), "");
    }
    /// The log that SQLite made for an earlier, other file must not heal or spoil this one.
    void spoil(const std::string& text)
    {
        std::filesystem::remove(database.string() + "-wal");
        std::filesystem::remove(database.string() + "-shm");
        put(database, text);
    }

    TemporaryFolder runs;
    std::filesystem::path run;
    std::filesystem::path database;
    std::string whole;
};

} // namespace

TEST_F(RunDamage, flippedBytesGiveRowsOrAReasonThatNamesTheFile)
{
    SplitMix64 random(5);
    int noticed = 0;
    for (int i = 0; i < 1000; ++i) {
        std::string damaged = whole;
        for (std::uint64_t k = 0; k <= below(random, 16); ++k)
            damaged[below(random, damaged.size())] = static_cast<char>(below(random, 256));
        spoil(damaged);
        const std::string trouble = troubleWith(run);
        noticed += trouble.empty() ? 0 : 1;
        EXPECT_TRUE(trouble.empty() || trouble.find(runDatabaseFile) != std::string::npos) << trouble;
    }
    EXPECT_GT(noticed, 200);
}

TEST_F(RunDamage, aTruncatedDatabaseIsNamed)
{
    for (std::size_t length = 0; length < whole.size() - 4096; length += 1021) {
        spoil(whole.substr(0, length));
        const std::string trouble = troubleWith(run);
        ASSERT_FALSE(trouble.empty()) << length;
        EXPECT_NE(trouble.find(runDatabaseFile), std::string::npos) << trouble;
    }
}

TEST_F(RunDamage, aDatabaseOfAnotherProgramIsNoRun)
{
    std::filesystem::remove(database);
    {
        auto other = SqliteDatabase::open(database, SqliteDatabase::Access::Create);
        ASSERT_TRUE(other && other->execute("CREATE TABLE things (a);"));
    }
    EXPECT_NE(troubleWith(run).find("damaged or no run"), std::string::npos) << troubleWith(run);
}

TEST_F(RunDamage, aDatabaseThatComputesIsRefused)
{
    {
        auto other = SqliteDatabase::open(database, SqliteDatabase::Access::Create);
        ASSERT_TRUE(other &&
                    other->execute("DROP TABLE events; CREATE VIEW events AS WITH RECURSIVE "
                                   "n(t_ns) AS (SELECT 1 UNION ALL SELECT 1 FROM n) SELECT t_ns, 1 AS "
                                   "level, '' AS source, '' AS text, 1 AS rowid FROM n;"));
    }
    EXPECT_NE(troubleWith(run).find("more than tables"), std::string::npos) << troubleWith(run);
}

TEST_F(RunDamage, aDamagedDescriptionIsNamed)
{
    const std::string info = contents(run / runInfoFile);
    for (std::size_t length = 0; length + 3 < info.size(); length += 7) {
        put(run / runInfoFile, info.substr(0, length));
        EXPECT_NE(troubleWith(run).find(runInfoFile), std::string::npos) << length;
    }
    put(run / runInfoFile, "[]");
    EXPECT_NE(troubleWith(run).find("damaged"), std::string::npos);
}

TEST_F(RunDamage, aRunOfANewerVersionSaysSo)
{
    std::string info = contents(run / runInfoFile);
    info.replace(info.find("\"format\": 1"), 11, "\"format\": 2");
    put(run / runInfoFile, info);
    EXPECT_NE(troubleWith(run).find("newer version"), std::string::npos);
}

TEST_F(RunDamage, missingFilesAreNamed)
{
    std::filesystem::remove(database);
    EXPECT_NE(troubleWith(run).find("is not there"), std::string::npos);
    std::filesystem::remove(run / runInfoFile);
    EXPECT_NE(troubleWith(run).find(runInfoFile), std::string::npos);
    EXPECT_FALSE(troubleWith(runs.path() / "nothing").empty());
}

} // namespace agv::recording::test
