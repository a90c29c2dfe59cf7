// SPDX-License-Identifier: GPL-3.0-or-later
// The port of the kit: the lines of each dialect, the handshake, and how bytes leave.
#include "simulation/uwb_kit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace agv::simulation {

namespace {

using protocol::TrekLineKind;
using protocol::TrekReport;

constexpr Duration silence = std::chrono::seconds(1);
constexpr std::size_t commandLength = 5;
constexpr std::size_t usbTransfer = 64;
constexpr std::size_t uartBurst = 16;
constexpr Duration usbGap = std::chrono::microseconds(300);
/// 16 bytes of 10 bits at 115200 baud.
constexpr Duration uartGap = std::chrono::nanoseconds(1'388'889);
/// By how much raw ranges are shorter than corrected ones, and the delays printed beside them.
constexpr std::int32_t rawOffset_mm = 220;
constexpr std::uint32_t antennaDelays = 0x40414041;
constexpr std::uint16_t receivePower = 7850;                      // -78.50 dBm
constexpr std::string_view deviceText = "TREK1000 UWB Mini     "; // 22 bytes
constexpr std::string_view versionText("Ver.2.25mx TREK\0", 16);

bool isUlm(UwbDialect dialect) { return dialect == UwbDialect::UlmFour || dialect == UwbDialect::UlmEight; }

std::string ulmText(const TrekReport& report)
{
    std::string text = "$NKT" + std::to_string(report.tag);
    for (std::size_t k = 0; k < report.rangeCount; ++k) {
        char field[32];
        std::snprintf(field, sizeof field, ",%.2f", metresFromMm(report.range_mm[k]));
        text += report.range_mm[k] > 0 ? field : ",null";
    }
    return text + ",LO=[no solution]";
}

} // namespace

std::uint32_t UwbKit::deviceTime_ms(Time at) const
{
    return static_cast<std::uint32_t>((at - m_booted) / std::chrono::milliseconds(1));
}

TrekReport UwbKit::reportOf(int id, const Ranges& ranges, std::uint8_t sequence, Time at) const
{
    const UwbDialect dialect = m_settings.dialect;
    TrekReport report;
    report.role = dialect == UwbDialect::Esp32 || dialect == UwbDialect::Imu ? UwbRole::Tag : UwbRole::Anchor;
    report.rangeCount = static_cast<std::uint8_t>(rangeCount());
    report.tag = static_cast<std::int16_t>(id);
    report.sequence = sequence;
    report.rangeNumber = m_rangeNumber;
    report.debug = protocol::trekTimeField(deviceTime_ms(at), dialect);
    report.range_mm = ranges;
    for (std::size_t k = 0; k < report.rangeCount; ++k) {
        if (ranges[k] > 0)
            report.mask = static_cast<std::uint8_t>(report.mask | 1U << k);
        else if (isUlm(dialect))
            report.range_mm[k] = -1;
    }
    if (isUlm(dialect)) {
        report.mask = 0; // the SOS byte
        report.power = receivePower;
    }
    return report;
}

void UwbKit::report(int id, const Ranges& ranges, std::uint8_t sequence, Time at)
{
    if (at < m_silentUntil)
        return;
    ++m_rangeNumber;
    if (m_settings.dialect == UwbDialect::TrekOld)
        return reportSingles(id, ranges, sequence, at);
    TrekReport report = reportOf(id, ranges, sequence, at);
    if (m_settings.dialect == UwbDialect::Imu) {
        report.kind = TrekLineKind::Imu;
        report.deviceTime_ms = deviceTime_ms(at);
        report.motionCount = 6;
        report.motion[2] = 9.81F;
    }
    print(encodeTrekReport(report), at);
    if (isUlm(m_settings.dialect))
        print(ulmText(report), at);
    if (!isTrek() || !m_rawReports)
        return;
    report.kind = TrekLineKind::Raw;
    report.debug = antennaDelays;
    for (std::size_t k = 0; k < report.rangeCount; ++k)
        report.range_mm[k] -= ranges[k] > 0 ? rawOffset_mm : 0;
    print(encodeTrekReport(report), at);
}

/// Firmware 1.06: a line for each anchor that was reached.
void UwbKit::reportSingles(int id, const Ranges& ranges, std::uint8_t sequence, Time at)
{
    for (std::size_t k = 0; k < rangeCount(); ++k) {
        if (ranges[k] <= 0)
            continue;
        TrekReport report = reportOf(id, ranges, sequence, at);
        report.kind = TrekLineKind::Single;
        report.firstAnchor = static_cast<std::uint8_t>(k);
        report.range_mm = {ranges[k]};
        report.unit = 0;
        print(encodeTrekReport(report), at);
    }
}

/// A0-A1, A0-A2 and A1-A2, once a period.
void UwbKit::reportAnchors(Time at)
{
    const std::uint8_t sequence = m_anchorSequence++;
    const bool isPrinted = m_settings.anchorRanges && at >= m_silentUntil && isPlugged(at);
    if (m_settings.dialect != UwbDialect::Trek || !isPrinted)
        return;
    constexpr std::array<std::array<std::size_t, 2>, 3> pairs{{{0, 1}, {0, 2}, {1, 2}}};
    TrekReport report = reportOf(0, Ranges{}, sequence, at);
    report.kind = TrekLineKind::Anchors;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const Anchor& first = m_anchors[pairs[k][0]];
        const Anchor& second = m_anchors[pairs[k][1]];
        if (!first.isPresent || !second.isPresent || first.isMissing || second.isMissing)
            continue;
        const double range_m = std::hypot(first.place.x - second.place.x, first.place.y - second.place.y,
                                          first.place.z - second.place.z) +
                               m_settings.model.noiseSd_m * m_random.normal();
        report.range_mm[k + 1] = std::max(1, static_cast<std::int32_t>(std::lround(mmFromMetres(range_m))));
        report.mask = static_cast<std::uint8_t>(report.mask | 1U << (k + 1));
    }
    if (report.mask != 0)
        print(encodeTrekReport(report), at);
}

void UwbKit::receive(std::string_view bytes, Time now)
{
    if (!isPlugged(now))
        return;
    m_receivedBytes += bytes.size();
    if (m_settings.dialect != UwbDialect::Trek)
        return;
    for (const char byte : bytes) {
        m_command += byte;
        if (m_command.size() > commandLength)
            m_command.erase(0, 1);
        answer(m_command, now);
    }
}

void UwbKit::answer(std::string_view command, Time now)
{
    if (command == "deca?") {
        m_rawReports = true;
        send("n" + std::string(deviceText), now);
    } else if (command == "deca$" || command == "decA$") {
        m_rawReports = m_rawReports && command == "deca$";
        const UwbConfiguration configuration{m_settings.fastMode, 2, UwbRole::Anchor, 0};
        std::string reply = "n" + std::string(versionText);
        reply += static_cast<char>(encodeUwbConfiguration(configuration));
        send(reply + "\r\n", now);
        m_silentUntil = now + silence;
    }
}

void UwbKit::print(std::string_view line, Time at) { send(std::string(line) + "\r\n", at); }

/// One line at a time, each after the one before.
void UwbKit::send(std::string_view bytes, Time at)
{
    if (!isPlugged(at))
        return;
    const bool isUsb = m_settings.framing == UwbFraming::UsbTransfers;
    const std::size_t most = m_settings.framing == UwbFraming::WholeLines ? bytes.size()
                             : isUsb                                      ? usbTransfer
                                                                          : uartBurst;
    Time leaves = std::max(at, m_portBusyUntil);
    while (!bytes.empty()) {
        const std::string_view piece = bytes.substr(0, most);
        m_output.push_back({leaves, std::string(piece)});
        leaves += isUsb ? usbGap : m_settings.framing == UwbFraming::UartBursts ? uartGap : Duration{};
        bytes.remove_prefix(piece.size());
    }
    m_portBusyUntil = leaves;
}

std::vector<UwbOutput> UwbKit::take(Time now)
{
    std::vector<UwbOutput> left;
    while (!m_output.empty() && m_output.front().at <= now) {
        left.push_back(std::move(m_output.front()));
        m_output.pop_front();
    }
    return left;
}

} // namespace agv::simulation
