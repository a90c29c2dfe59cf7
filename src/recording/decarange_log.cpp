// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/decarange_log.h"

#include "recording/number_text.h"
#include "recording/text_lines.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace agv::recording {

namespace {

constexpr double secondsOfDay = 86400.0;
constexpr double stepBack_s = 1.0;
constexpr std::string_view recordBegin = "T:";
constexpr std::size_t timeDigits = 9;
constexpr std::size_t mostTimeDigits = 12;

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::size_t digitsAt(std::string_view text, std::size_t at)
{
    std::size_t n = 0;
    while (at + n < text.size() && n <= mostTimeDigits && isDigit(text[at + n]))
        ++n;
    return n;
}

/// Does a record begin here? Inside a line only one with a whole time.
bool isRecordAt(std::string_view line, std::size_t at)
{
    if (!line.substr(at).starts_with(recordBegin))
        return false;
    const std::size_t digits = digitsAt(line, at + recordBegin.size());
    const std::size_t end = at + recordBegin.size() + digits;
    const bool isTime = at == 0 ? digits >= 1 && digits <= mostTimeDigits : digits == timeDigits;
    return isTime && end < line.size() && line[end] == ':';
}

std::size_t nextRecord(std::string_view line, std::size_t from)
{
    for (std::size_t at = line.find(recordBegin, from); at != std::string_view::npos;
         at = line.find(recordBegin, at + 1))
        if (isRecordAt(line, at))
            return at;
    return line.size();
}

std::vector<std::string_view> fieldsOf(std::string_view record)
{
    std::vector<std::string_view> fields;
    for (;;) {
        const std::size_t end = std::min(record.find(':'), record.size());
        fields.push_back(trimmed(record.substr(0, end)));
        if (end == record.size())
            return fields;
        record.remove_prefix(end + 1);
    }
}

/// "hhmmsszzz" as seconds of the day; nothing when there is no such time.
std::optional<double> timeOfDay_s(std::string_view digits)
{
    if (digits.size() != timeDigits)
        return std::nullopt;
    const int hours = *parseInteger(digits.substr(0, 2));
    const int minutes = *parseInteger(digits.substr(2, 2));
    const int seconds = *parseInteger(digits.substr(4, 2));
    const int milliseconds = *parseInteger(digits.substr(6, 3));
    if (hours > 23 || minutes > 59 || seconds > 59)
        return std::nullopt;
    return hours * 3600 + minutes * 60 + seconds + milliseconds / 1e3;
}

/// One record behind its time.
struct Record {
    int line = 0;
    std::optional<double> timeOfDay_s;
    std::vector<std::string_view> fields; ///< [0] is the kind

    std::optional<int> integer(std::size_t i) const
    {
        return i < fields.size() ? parseInteger(fields[i]) : std::nullopt;
    }
    std::optional<double> number(std::size_t i) const
    {
        return i < fields.size() ? parseNumber(fields[i]) : std::nullopt;
    }
};

class LogReader {
public:
    Result<DecaRangeLog> read(std::string_view text)
    {
        for (const TextLine& line : linesOf(text))
            readLine(line);
        for (auto& [tag, exchange] : m_open)
            close(exchange);
        for (const auto& [id, anchor] : m_anchors)
            m_log.anchors.push_back(anchor);
        if (!m_hasRecords)
            return failure(ErrorCode::BadInput, "holds no record of DecaRangeRTLS; expected lines like "
                                                "T:090531088:RR:0:0:760:760:229:3301");
        return std::move(m_log);
    }

private:
    /// Rows of one tag with the same RSEQ and nranges.
    struct Exchange {
        int sequence = -1;
        int rangeCount = -1;
        std::vector<std::size_t> rows;
        std::vector<double> times_s; ///< of the day
    };

    void readLine(const TextLine& line)
    {
        std::size_t begin = nextRecord(line.text, 0);
        if (!trimmed(line.text.substr(0, begin)).empty())
            ++m_log.otherLines;
        while (begin < line.text.size()) {
            const std::size_t end = nextRecord(line.text, begin + recordBegin.size());
            readRecord(line.number, line.text.substr(begin, end - begin));
            begin = end;
        }
    }

    void readRecord(int line, std::string_view text)
    {
        m_hasRecords = true;
        text.remove_prefix(recordBegin.size());
        const std::size_t digits = digitsAt(text, 0);
        const Record record{line, timeOfDay_s(text.substr(0, digits)), fieldsOf(text.substr(digits + 1))};
        const std::string_view kind = record.fields.front();
        if (kind == "RR" || kind == "RA")
            readRange(record, kind == "RR" ? RangeKind::TagAnchor : RangeKind::AnchorAnchor);
        else if (kind == "AP")
            readAnchor(record);
        else if (kind == "LE")
            readFix(record);
        else if (kind != "DecaRangeRTLS")
            ++m_log.otherRecords;
    }

    /// tag : anchor : range : corrected : rseq : nranges
    void readRange(const Record& record, RangeKind kind)
    {
        const auto tag = record.integer(1);
        const auto anchor = record.integer(2);
        const auto range_mm = record.integer(3);
        const auto corrected_mm = record.integer(4);
        const auto sequence = record.integer(5);
        const auto rangeCount = record.integer(6);
        const bool isWhole = tag && anchor && range_mm && corrected_mm && sequence && rangeCount;
        if (!isWhole || record.fields.size() != 7 || *tag < 0 || *anchor < 0 || *sequence < 0)
            return problem(record, "tag:anchor:range:corrected:rseq:nranges");
        if (*range_mm <= 0) {
            ++m_log.table.notMeasured;
            return;
        }
        const int unit = kind == RangeKind::TagAnchor ? *tag : -1;
        Exchange& exchange = m_open[unit];
        if (exchange.sequence != *sequence || exchange.rangeCount != *rangeCount) {
            close(exchange);
            exchange.sequence = *sequence;
            exchange.rangeCount = *rangeCount;
        }
        exchange.rows.push_back(m_log.table.ranges.size());
        if (record.timeOfDay_s)
            exchange.times_s.push_back(*record.timeOfDay_s);
        m_log.table.ranges.push_back({.time_s = m_latest_s.value_or(0.0),
                                      .range_m = metresFromMm(*range_mm),
                                      .tag = *tag,
                                      .anchor = *anchor,
                                      .sequence = *sequence,
                                      .kind = kind});
        m_log.table.extras.push_back(std::to_string(*rangeCount));
        const bool isTag = kind == RangeKind::TagAnchor;
        m_log.table.extras.push_back(isTag ? exactNumberText(metresFromMm(*corrected_mm)) : std::string());
    }

    /// anchor : x : y : z
    void readAnchor(const Record& record)
    {
        const auto id = record.integer(1);
        const auto x = record.number(2);
        const auto y = record.number(3);
        const auto z = record.number(4);
        if (!id || !x || !y || !z || *id < 0)
            return problem(record, "anchor:x:y:z");
        m_anchors[*id] = {.id = *id, .label = "A" + std::to_string(*id), .x = *x, .y = *y, .z = *z};
    }

    /// tag : count : rseq : [x,y,z] : r0 : r1 : r2 : r3
    void readFix(const Record& record)
    {
        const auto tag = record.integer(1);
        const auto sequence = record.integer(3);
        std::string_view place = record.fields.size() > 4 ? record.fields[4] : std::string_view();
        LoggedFix fix{.time_s = place_s(record.timeOfDay_s),
                      .tag = tag.value_or(-1),
                      .sequence = sequence.value_or(-1)};
        bool isPlace = place.starts_with('[') && place.ends_with(']');
        if (isPlace)
            place = place.substr(1, place.size() - 2);
        for (double& coordinate : fix.position_m) {
            const std::size_t end = std::min(place.find(','), place.size());
            const auto value = parseNumber(trimmed(place.substr(0, end)));
            isPlace = isPlace && value;
            coordinate = value.value_or(0.0);
            place.remove_prefix(std::min(end + 1, place.size()));
        }
        if (!isPlace || fix.tag < 0 || fix.sequence < 0)
            return problem(record, "tag:count:rseq:[x,y,z]:r0:r1:r2:r3");
        m_log.fixes.push_back(fix);
    }

    void problem(const Record& record, const char* expected)
    {
        m_log.table.problems.add(record.line, "a record of kind " + inQuotes(record.fields.front()) +
                                                  " breaks its form; expected " + expected);
    }

    /// Gives all rows of an exchange their time.
    void close(Exchange& exchange)
    {
        if (exchange.rows.empty())
            return;
        std::ranges::sort(exchange.times_s);
        const std::size_t n = exchange.times_s.size();
        const auto median_s = n > 0 ? std::optional(exchange.times_s[(n - 1) / 2]) : std::nullopt;
        const double time_s = place_s(median_s);
        if (m_latest_s && time_s < *m_latest_s - stepBack_s)
            ++m_log.stepsBack;
        m_latest_s = time_s;
        for (const std::size_t row : exchange.rows)
            m_log.table.ranges[row].time_s = time_s;
        exchange = {};
    }

    /// The time of day on the day that brings it nearest to the exchange before: the log has no date, and may
    /// go over midnight, have a wrong time, or be joined of several.
    double place_s(std::optional<double> timeOfDay_s) const
    {
        if (!timeOfDay_s)
            return m_latest_s.value_or(0.0);
        const double latest_s = m_latest_s.value_or(*timeOfDay_s);
        return *timeOfDay_s + std::round((latest_s - *timeOfDay_s) / secondsOfDay) * secondsOfDay;
    }

    DecaRangeLog m_log = [] {
        DecaRangeLog log;
        log.table.extraColumns = {"nranges", "corrected_m"};
        return log;
    }();
    std::map<int, Exchange> m_open; ///< by tag; -1: anchor-anchor ranges
    std::map<int, UwbAnchor> m_anchors;
    std::optional<double> m_latest_s;
    bool m_hasRecords = false;
};

} // namespace

bool looksLikeDecaRangeLog(std::string_view text)
{
    constexpr std::size_t enough = 4096;
    const std::string_view begin = text.substr(0, enough);
    if (begin.find(":DecaRangeRTLS:") != std::string_view::npos)
        return true;
    for (const TextLine& line : linesOf(begin)) {
        const std::size_t at = nextRecord(line.text, 0);
        if (at < line.text.size() && isRecordAt(line.text.substr(at), 0))
            return true;
    }
    return false;
}

Result<DecaRangeLog> readDecaRangeLog(std::string_view text) { return LogReader().read(text); }

} // namespace agv::recording
