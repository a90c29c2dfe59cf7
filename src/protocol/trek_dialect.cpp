// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/trek_dialect.h"

namespace agv::protocol {

namespace {

constexpr int votesToChange = 3;

struct MaskCheck {
    bool anyRange = false;
    bool rangeWithoutBit = false;
};

MaskCheck checkMask(const TrekReport& report)
{
    MaskCheck check;
    for (std::size_t k = 0; k < report.rangeCount; ++k) {
        if (report.range_mm[k] == 0 || report.range_mm[k] == -1)
            continue;
        check.anyRange = true;
        check.rangeWithoutBit |= (report.mask >> k & 1U) == 0;
    }
    return check;
}

} // namespace

void TrekDialectDetector::observe(const TrekReport& report)
{
    if (report.kind == TrekLineKind::Single)
        return vote(UwbDialect::TrekOld, "lines with one anchor each");
    if (report.kind == TrekLineKind::Imu)
        return vote(UwbDialect::Imu, "comma lines");
    if (report.rangeCount == mostTrekRanges)
        return vote(UwbDialect::UlmEight, "eight ranges");
    if (report.power)
        return vote(UwbDialect::UlmFour, "receive power behind the ids");
    const MaskCheck mask = checkMask(report);
    if (mask.rangeWithoutBit)
        return vote(UwbDialect::UlmFour, "ranges that the second field, taken as a mask, denies");
    if (!mask.anyRange)
        return;
    // The debug field of mr lines holds antenna delays.
    if (report.kind == TrekLineKind::Corrected && report.role == UwbRole::Tag && report.debug == 0)
        return vote(UwbDialect::Esp32, "a mask of valid ranges, and no time");
    vote(UwbDialect::Trek, "a mask of valid ranges");
}

void TrekDialectDetector::observeText(std::string_view line)
{
    if (!line.starts_with("$NKT") && !line.starts_with("$KT"))
        return;
    const bool isEight = m_detected == UwbDialect::UlmEight;
    vote(isEight ? UwbDialect::UlmEight : UwbDialect::UlmFour, "lines beginning with $NKT or $KT");
}

void TrekDialectDetector::vote(UwbDialect dialect, const char* evidence)
{
    if (dialect == m_detected) {
        m_votesForRival = 0;
        return;
    }
    if (m_detected != UwbDialect::Unknown) {
        ++m_contradictions;
        m_votesForRival = dialect == m_rival ? m_votesForRival + 1 : 1;
        m_rival = dialect;
        if (m_votesForRival < votesToChange)
            return;
    }
    m_detected = dialect;
    m_evidence = evidence;
    m_votesForRival = 0;
}

void TrekDialectDetector::reset()
{
    m_detected = UwbDialect::Unknown;
    m_evidence = "";
    m_votesForRival = 0;
    m_contradictions = 0;
}

} // namespace agv::protocol
