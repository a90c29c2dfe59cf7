// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/random.h"
#include "simulation/plant_settings.h"
#include "simulation/tag_floor.h"

#include <string>
#include <vector>

namespace agv::simulation {

/// The RFID reader of one AGV in its automatic anti-collision mode (AT+Scan=AC,RSSI): rounds over the tags in
/// range, one answer a slot, and the lines it prints about them.
class RfidReader {
public:
    /// `table` as in the plant file; `random` draws this reader's own table errors and all its noise.
    RfidReader(const ReaderModel& model, const RssiTable& table, SplitMix64 random, Time start);

    /// Prints what happened up to `now`; the antenna is at `antenna` (plant frame).
    void step(Time now, Point2 antenna, const TagFloor& floor);
    /// Bytes printed since the last call.
    std::string takeBytes();

    /// Share of answers, and of (tag, place) pairs, that are lost: 0..1.
    void setMissRate(double share);
    /// All edges of the RSSI table are `share` too far out, e.g. 0.08 (or too near, when negative).
    void setTableError(double share);
    /// Line noise: `count` random bytes in the middle of everything else.
    void printGarbage(std::size_t count);
    void restore();

private:
    struct Answer {
        std::size_t tag;
        int rssi; ///< at the start of the round
    };

    void startRound(Time now, Point2 antenna, const TagFloor& floor);
    void answer(const Answer& expected, Point2 antenna, const TagFloor::Tag& tag);
    std::optional<int> rssiOf(Point2 antenna, Point2 tag) const;
    bool isDeaf(Point2 antenna, TagUid tag) const;
    int noisy(int rssi, Point2 antenna, TagUid tag);
    double placeHash(Point2 antenna, TagUid tag, std::uint64_t purpose) const;
    void printRead(TagUid tag, int rssi);
    void printLine(std::string_view text);

    ReaderModel m_model;
    ReaderModel m_healthy;
    RssiTable m_table;
    double m_tableFactor = 1.0;
    SplitMix64 m_random;
    std::uint64_t m_placeSeed;
    Time m_nextSlot;
    Time m_lastPrint;
    std::vector<Answer> m_round;
    std::size_t m_slot = 0;
    std::string m_bytes;
};

} // namespace agv::simulation
