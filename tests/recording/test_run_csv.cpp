// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/run_support.h"

#include "recording/run_csv.h"
#include "recording/run_csv_rows.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <sys/stat.h>

namespace agv::recording::test {
namespace {

std::string textOf(const std::filesystem::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// RFC 4180, read independently of how it is written.
std::vector<std::vector<std::string>> parseCsv(const std::string& text)
{
    std::vector<std::vector<std::string>> rows(1, {std::string()});
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
            rows.back().back() += text[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (quoted)
            rows.back().back() += c;
        else if (c == ',')
            rows.back().emplace_back();
        else if (c == '\n')
            rows.push_back({std::string()});
        else if (c != '\r')
            rows.back().back() += c;
    }
    rows.pop_back(); // behind the last line end
    return rows;
}

/// As any program would read it: a number, scaled to what is stored.
std::int64_t storedNumber(const std::string& field, const RunColumn& column)
{
    for (std::size_t i = 0; i < column.words.size(); ++i) {
        if (field == column.words[i])
            return static_cast<std::int64_t>(i);
    }
    if (column.kind == ColumnKind::TagNumber) {
        std::uint64_t uid = 0;
        std::from_chars(field.data(), field.data() + field.size(), uid, 16);
        return static_cast<std::int64_t>(uid);
    }
    double value = std::numeric_limits<double>::quiet_NaN();
    const auto [end, problem] = std::from_chars(field.data(), field.data() + field.size(), value);
    EXPECT_TRUE(problem == std::errc() && end == field.data() + field.size()) << field;
    return std::llround(value * std::pow(10.0, column.decimals));
}

void expectSame(const std::vector<std::string>& fields, const StoredRow& row, const RunTable& table)
{
    ASSERT_EQ(fields.size(), row.cells.size() + 2);
    EXPECT_EQ(std::llround(std::stod(fields[1]) * 1e9), row.t_ns);
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const std::string& field = fields[i + 2];
        if (const auto* number = std::get_if<std::int64_t>(&row.cells[i])) {
            EXPECT_EQ(storedNumber(field, table.columns[i]), *number) << table.columns[i].title;
        } else if (const auto* text = std::get_if<std::string>(&row.cells[i])) {
            EXPECT_TRUE(field == *text || field == "'" + *text) << field;
        } else {
            EXPECT_EQ(field, "");
        }
    }
}

class RunCsv : public testing::Test {
protected:
    void SetUp() override
    {
        auto writer = newRun(runs.path());
        ASSERT_TRUE(writer);
        SplitMix64 random(11);
        for (int k = 0; k < 40; ++k)
            ASSERT_TRUE(
                writer->append(randomBatch(random, startTime + k * std::chrono::milliseconds(500), 200)));
        ASSERT_TRUE(writer->finish(0));
        auto opened = RunReader::open(writer->folder());
        ASSERT_TRUE(opened);
        run.emplace(std::move(*opened));
    }

    TemporaryFolder runs;
    std::optional<RunReader> run;
    std::filesystem::path out = runs.path() / "csv";
};

} // namespace

TEST_F(RunCsv, everyNumberReadsBackEqualToWhatTheRunHolds)
{
    const auto done = exportCsv(*run, out);
    ASSERT_TRUE(done) << done.error().detail;
    EXPECT_EQ(done->files.size(), runTableCount + 2);
    for (std::size_t table = 0; table < runTableCount; ++table) {
        const auto lines = parseCsv(textOf(out / (std::string(runTables()[table].name) + ".csv")));
        const auto rows = rowsOf(*run, table);
        ASSERT_TRUE(rows);
        ASSERT_EQ(lines.size(), rows->size() + 1) << runTables()[table].name;
        for (std::size_t i = 0; i < rows->size(); ++i)
            expectSame(lines[i + 1], (*rows)[i], runTables()[table]);
    }
}

TEST_F(RunCsv, theHeadersNameTheUnitsAndNoFileHasAByteOrderMark)
{
    ASSERT_TRUE(exportCsv(*run, out));
    const auto firstLine = [&](const char* name) {
        const std::string text = textOf(out / name);
        return text.substr(0, text.find("\r\n"));
    };
    EXPECT_EQ(firstLine("ranges.csv"),
              "t_utc,t_s,age_ms,kind,tag,anchor,sequence,range_mm,residual_mm,rejected");
    EXPECT_EQ(firstLine("poses.csv"), "t_utc,t_s,agv,x_mm,y_mm,heading_deg,sd_x_mm,sd_y_mm,sd_heading_deg,"
                                      "correlation_xy,correlation_x_heading,correlation_y_heading,health");
    EXPECT_EQ(firstLine("floor_reads.csv"), "t_utc,t_s,agv,uid,rssi");
    EXPECT_EQ(firstLine("raw.csv"), "t_utc,t_s,link,bytes");
    EXPECT_EQ(textOf(out / runInfoFile), textOf(run->folder() / runInfoFile));
}

TEST_F(RunCsv, aSpreadsheetComputesNoText)
{
    ASSERT_TRUE(exportCsv(*run, out));
    const auto lines = parseCsv(textOf(out / "events.csv"));
    EXPECT_EQ(lines.at(1).at(4), "'=1+1; größer");
    const auto results = parseCsv(textOf(out / "turn_results.csv"));
    EXPECT_EQ(results.at(1).back(), "ok, \"sure\"\r\nof it");
}

TEST_F(RunCsv, timesAreOfTheWallClockInUtcAndOfTheRun)
{
    ASSERT_TRUE(exportCsv(*run, out));
    const auto lines = parseCsv(textOf(out / "raw.csv"));
    EXPECT_EQ(lines.at(1).at(0), "2026-03-17T15:30:05.123Z");
    EXPECT_EQ(lines.at(1).at(1), "0.000000000");
    EXPECT_EQ(lines.at(2).at(1), "0.002500000");
    EXPECT_EQ(lines.at(2).at(0), "2026-03-17T15:30:05.125Z");
}

TEST_F(RunCsv, aCancelledExportLeavesNothingBehind)
{
    int asked = 0;
    const auto cancelled = exportCsv(*run, out, [&](double fraction) {
        EXPECT_TRUE(fraction > 0.0 && fraction <= 1.0);
        return ++asked < 2;
    });
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::Cancelled);
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(RunCsv, anExportThatFailsLeavesTheFilesOfAnEarlierOneAlone)
{
    std::filesystem::create_directory(out);
    std::ofstream(out / "events.csv") << "earlier";
    std::filesystem::create_directory(out / "raw.csv.partial"); // in the way of the last file
    const auto failed = exportCsv(*run, out);
    ASSERT_FALSE(failed);
    EXPECT_NE(failed.error().detail.find("raw.csv"), std::string::npos);
    EXPECT_EQ(textOf(out / "events.csv"), "earlier");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), {}), 2);
}

TEST_F(RunCsv, anImpossibleFolderIsNamed)
{
    std::ofstream(runs.path() / "file") << "x";
    const auto failed = exportCsv(*run, runs.path() / "file" / "csv");
    ASSERT_FALSE(failed);
    EXPECT_NE(failed.error().detail.find("file"), std::string::npos);
}

TEST(DecimalText, isExactForEveryIntegerAndPlace)
{
    const auto text = [](std::int64_t value, int decimals) {
        std::string result = "x";
        appendDecimal(result, value, decimals);
        return result.substr(1);
    };
    EXPECT_EQ(text(0, 3), "0.000");
    EXPECT_EQ(text(-1, 3), "-0.001");
    EXPECT_EQ(text(-1500, 3), "-1.500");
    EXPECT_EQ(text(1234567, 6), "1.234567");
    EXPECT_EQ(text(-42, 0), "-42");
    EXPECT_EQ(text(std::numeric_limits<std::int64_t>::min(), 0), "-9223372036854775808");
}

TEST(EscapedBytes, areReadableWhateverTheyAre)
{
    std::string text;
    appendEscapedBytes(text, std::string_view("a\\b\r\n\t\0\xff", 8));
    EXPECT_EQ(text, "a\\\\b\\r\\n\\t\\x00\\xFF");
}

} // namespace agv::recording::test
