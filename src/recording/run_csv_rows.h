// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/run_reader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace agv::recording {

/// Appends `value` / 10^decimals as exact decimal text: -1500 with 3 decimals is "-1.500".
void appendDecimal(std::string& text, std::int64_t value, int decimals);

/// Bytes as readable text: printable ASCII as it is, a backslash doubled, \r, \n, \t, everything else \xHH.
void appendEscapedBytes(std::string& text, std::string_view bytes);

/// Makes the lines of one CSV file.
class CsvRowWriter {
public:
    explicit CsvRowWriter(const RunReader& run) : m_run(run) {}

    static std::string header(const RunTable& table);
    static std::string rawHeader();
    void append(std::string& text, const RunTable& table, const RunReader::Row& row);
    void appendRaw(std::string& text, const RunChunk& chunk);

private:
    void appendTimes(std::string& text, std::int64_t t_ns);

    const RunReader& m_run;
    std::int64_t m_second = -1; ///< that m_secondText is of
    std::string m_secondText;   ///< "2026-03-17T15:30:05."
    std::string m_scratch;
};

} // namespace agv::recording
