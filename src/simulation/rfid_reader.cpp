// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/rfid_reader.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace agv::simulation {
namespace {

constexpr int strongest = 7;

/// The table of one reader: every edge scaled and shifted, still falling.
RssiTable withErrors(RssiTable table, const ReaderModel& model, SplitMix64& random)
{
    const double scale = 1.0 + model.tableScaleSd * random.normal();
    std::vector<double> edges;
    for (const RssiStep& step : table)
        edges.push_back(std::max(1e-3, step.upperEdge * scale + model.tableEdgeSd_m * random.normal()));
    std::ranges::sort(edges, std::greater{});
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i].upperEdge = edges[i];
    return table;
}

} // namespace

RfidReader::RfidReader(const ReaderModel& model, const RssiTable& table, SplitMix64 random, Time start)
    : m_model(model),
      m_healthy(model),
      m_random(random),
      m_placeSeed(m_random.next()),
      m_lastPrint(start)
{
    m_table = withErrors(table, model, m_random);
    // The bridge sends AT+Scan=OFF and AT+Scan=AC,RSSI when it starts (seed, appendix N); both are answered.
    printLine("OK");
    printLine("OK");
    m_nextSlot = start + std::chrono::milliseconds(1 + static_cast<int>(m_random.uniform(0.0, 30.0)));
}

void RfidReader::step(Time now, Point2 antenna, const TagFloor& floor)
{
    while (m_nextSlot <= now) {
        if (m_slot >= m_round.size()) {
            startRound(m_nextSlot, antenna, floor);
        } else {
            const Answer& expected = m_round[m_slot++];
            answer(expected, antenna, floor.tags()[expected.tag]);
        }
        m_nextSlot += m_model.slot;
        if (m_model.slotJitter_s > 0.0)
            m_nextSlot += durationFromSeconds(m_random.exponential(m_model.slotJitter_s));
    }
}

void RfidReader::startRound(Time now, Point2 antenna, const TagFloor& floor)
{
    m_round.clear();
    m_slot = 0;
    const double range = m_table.empty() ? 0.0 : m_table.front().upperEdge * m_tableFactor;
    for (const std::size_t tag : floor.within(antenna, range))
        if (const auto rssi = rssiOf(antenna, floor.tags()[tag].position))
            m_round.push_back({tag, *rssi});
    for (std::size_t i = m_round.size(); i > 1; --i)
        std::swap(m_round[i - 1], m_round[m_random.next() % i]);
    if (!m_round.empty()) {
        m_lastPrint = now;
    } else if (now - m_lastPrint >= m_model.idleReply) {
        printLine("OK");
        m_lastPrint = now;
    }
}

void RfidReader::answer(const Answer& expected, Point2 antenna, const TagFloor::Tag& tag)
{
    const auto rssi = rssiOf(antenna, tag.position);
    if (!rssi || tag.dead) {
        if (m_random.uniform() < m_model.lateRate)
            printRead(tag.uid, expected.rssi);
        return;
    }
    if (isDeaf(antenna, tag.uid) || m_random.uniform() < m_model.missRate)
        return;
    if (m_random.uniform() < m_model.incompleteRate)
        printLine("SCAN:-UID=" + fullText(tag.uid));
    else
        printRead(tag.uid, noisy(*rssi, antenna, tag.uid));
}

std::optional<int> RfidReader::rssiOf(Point2 antenna, Point2 tag) const
{
    return rssiAt(m_table, distance(antenna, tag) / m_tableFactor);
}

double RfidReader::placeHash(Point2 antenna, TagUid tag, std::uint64_t purpose) const
{
    const auto cell = [this](double along) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(along / m_model.placeSize_m)));
    };
    std::uint64_t hash = SplitMix64::mix(m_placeSeed ^ tag.value);
    hash = SplitMix64::mix(hash + cell(antenna.x));
    hash = SplitMix64::mix(hash + cell(antenna.y));
    return SplitMix64(hash + purpose).uniform();
}

bool RfidReader::isDeaf(Point2 antenna, TagUid tag) const
{
    return placeHash(antenna, tag, 0) < m_model.deafRate;
}

int RfidReader::noisy(int rssi, Point2 antenna, TagUid tag)
{
    const auto oneOff = [&rssi](double draw, double rate) {
        if (draw < rate)
            rssi = std::clamp(draw < 0.5 * rate ? rssi - 1 : rssi + 1, 0, strongest);
    };
    oneOff(placeHash(antenna, tag, 1), m_model.placeNoiseRate);
    oneOff(m_random.uniform(), m_model.noiseRate);
    return rssi;
}

void RfidReader::printRead(TagUid tag, int rssi)
{
    // "almost similar with the first one, but always smaller" (seed, chapter 5.1); the examples show equal
    // ones too.
    const int auxiliary = m_random.uniform() < 0.5 ? rssi : std::max(0, rssi - 1);
    printLine("SCAN:+UID=" + fullText(tag) + ",+RSSI=" + std::to_string(rssi) + "/" +
              std::to_string(auxiliary));
}

void RfidReader::printLine(std::string_view text)
{
    m_bytes += text;
    m_bytes += "\r\n";
}

std::string RfidReader::takeBytes() { return std::exchange(m_bytes, {}); }

void RfidReader::setMissRate(double share)
{
    m_model.missRate = share;
    m_model.deafRate = share;
}

void RfidReader::setTableError(double share) { m_tableFactor = 1.0 + share; }

void RfidReader::printGarbage(std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        m_bytes += static_cast<char>(m_random.next() & 0xFF);
}

void RfidReader::restore()
{
    m_model = m_healthy;
    m_tableFactor = 1.0;
}

} // namespace agv::simulation
