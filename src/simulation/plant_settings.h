// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"

#include <cstdint>
#include <optional>

/// The plant made of numbers. What it models, and where each relation comes from:
///
/// * **Base**: differential drive, v = (l + r) / 2, w = (r - l) / track; track 286.5 mm and 330 mm across
/// (seed,
///   chapter 7.2: +-100 mm/s for 1125 ms turn by 45 degrees, so 112.5 mm of wheel travel per 45 degrees).
/// * **Battery and speed**: the wheels turn with `commanded x factor(charge)`, because "this time strongly
///   depends on the battery charge" (seed, chapter 7.2). The factor is linear from 0.80 (empty) to 1.04
///   (full), so a fixed sleeptime turns by 36 to 47 degrees: the range of table 10 and of the study's
///   scenarios A3 to A7.
/// * **Wheel errors**: per-robot imbalance of the wheels, slip as a random walk over the distance travelled,
/// and
///   encoders that see the wheels but not the slip and carry a scale error of their own (study, section C.2).
/// * **Reader**: RSSI step table with the blind spot (seed, appendix A and chapter 6.2), at least 30 ms
/// between reads,
///   anti-collision rounds in random order whose members are chosen at the start of the round (seed, chapter
///   8: "an unknown amount of time until each and every tag is identified"), misses, incomplete lines, late
///   answers of tags that have left the range, RSSI one off (study, section A.1: q, misses, stale tags).
/// * **Errors that are the same at the same place** (tag not heard, RSSI one off) are a hash of tag and
///   antenna position: reading longer does not average them away, as on a real floor.
///
/// Not documented anywhere and therefore assumptions: wheel acceleration, battery voltages and currents, that
/// Error is left by `interrupt`, that a new connection starts a new count of segments, and the docking
/// manoeuvres.
namespace agv::simulation {

struct DriveModel {
    double fullBatteryFactor = 1.04;  ///< wheel speed / commanded speed at 100 % charge
    double emptyBatteryFactor = 0.80; ///< the same at 0 %
    double acceleration_m_s2 = 1.0;   ///< limit of each wheel, speeding up and braking
    double imbalanceSd = 0.003;       ///< of (right - left) / 2 relative to commanded, per robot
    double slipNoise_sqrtM = 0.003;   ///< sd of a wheel's lost travel after 1 m; grows with the square root
    double encoderScaleSd = 0.005;    ///< relative, per robot
};

struct BatteryModel {
    double capacity_Ah = 3.0;        ///< of the base's pack
    double emptyVoltage_V = 13.2;    ///< at rest, 0 % (twelve NiMH cells)
    double fullVoltage_V = 16.0;     ///< at rest, 100 %
    double resistance_Ohm = 0.20;    ///< inside the pack
    double idleCurrent_A = 0.25;     ///< electronics
    double driveCurrent_A_s_m = 1.5; ///< per wheel and m/s
    double chargeCurrent_A = 1.25;   ///< on the home base
    double trickleAbove = 0.98;      ///< charge from which the base only trickles
};

struct ReaderModel {
    Duration slot = std::chrono::milliseconds(30); ///< least time between two answers
    double slotJitter_s = 0.004;                   ///< mean of an exponential added to each slot
    double missRate = 0.05;                        ///< share of single answers that get lost
    double deafRate = 0.02;       ///< share of (tag, place) pairs where the tag is never heard
    double incompleteRate = 0.04; ///< share of answers that end in a collision: SCAN:-UID=...
    double noiseRate = 0.15;      ///< share of reads whose RSSI is one off, each read anew
    double placeNoiseRate = 0.20; ///< share of (tag, place) pairs whose RSSI is always one off
    double placeSize_m = 0.015;   ///< side of a "place"
    double lateRate = 0.30;       ///< share of tags that left the range within a round and are still reported
    double antennaErrorSd_m = 0.001;                     ///< mounting error per robot, along and across
    double tagErrorSd_m = 0.001;                         ///< placement error per tag and axis
    double tableScaleSd = 0.01;                          ///< per robot: all edges of the RSSI table together
    double tableEdgeSd_m = 0.0005;                       ///< per robot: each edge for itself
    Duration idleReply = std::chrono::milliseconds(500); ///< OK lines while no tag is in range
};

struct PlantSettings {
    std::uint64_t seed = 1;
    std::optional<double> charge; ///< 0..1, of every battery; empty: 0.4 to 1, drawn per robot
    DriveModel drive;
    BatteryModel battery;
    ReaderModel reader;
};

/// The same plant without any error: nominal charge (factor 1), no noise, no misses; for tests that check
/// the kinematics and the RSSI table exactly.
PlantSettings idealSettings(std::uint64_t seed = 1);

} // namespace agv::simulation
