// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/uwb_unit.h"
#include "protocol/trek_line.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace agv::protocol {

/// Finds the dialect of a stream from what its lines say, because the same bytes mean different things: with
/// field 2 = 00 and four ranges, TREK measured none of them and a clone all four.
///
/// | line                                          | speaks for |
/// |-----------------------------------------------|------------|
/// | maAA tTT ...                                  | TrekOld    |
/// | mi,...                                        | Imu        |
/// | eight ranges                                  | UlmEight   |
/// | receive power behind the ids                  | UlmFour    |
/// | a range where field 2 has no bit              | UlmFour    |
/// | $NKT..., $KT...                               | UlmFour, unless it is UlmEight |
/// | ranges just where field 2 has bits, tag, time 0 | Esp32    |
/// | the same otherwise                            | Trek       |
///
/// The first line that speaks decides. Later ones change it only when three in a row, none in between for the
/// dialect in force, say the same, so that one damaged line does not; until then they are contradictions.
class TrekDialectDetector {
public:
    void observe(const TrekReport& report);
    /// A line that is not a report.
    void observeText(std::string_view line);
    /// After a reconnection: it may be another unit. The override stays.
    void reset();

    /// The operator's choice; nothing: as detected.
    void setOverride(std::optional<UwbDialect> dialect) { m_override = dialect; }
    std::optional<UwbDialect> override() const { return m_override; }

    /// In force: the override, else what was detected.
    UwbDialect dialect() const { return m_override.value_or(m_detected); }
    UwbDialect detected() const { return m_detected; }
    /// What spoke for the dialect detected, in words; empty while nothing did.
    const char* evidence() const { return m_evidence; }
    /// Lines that spoke for another dialect than the detected one.
    std::uint64_t contradictions() const { return m_contradictions; }

private:
    void vote(UwbDialect dialect, const char* evidence);

    std::optional<UwbDialect> m_override;
    UwbDialect m_detected = UwbDialect::Unknown;
    const char* m_evidence = "";
    UwbDialect m_rival = UwbDialect::Unknown;
    int m_votesForRival = 0;
    std::uint64_t m_contradictions = 0;
};

} // namespace agv::protocol
