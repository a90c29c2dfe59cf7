// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/collision_map.h"
#include "simulation/rfid_reader.h"
#include "simulation/robot.h"
#include "simulation/tag_floor.h"

namespace agv::simulation {

/// What is really so, for tests, training and the truth log.
struct RobotTruth {
    RobotId id;
    Pose2 pose;
    Point2 antenna;     ///< true place, with its mounting error
    WheelSpeeds wheels; ///< true
    WheelSpeeds commanded;
    RobotState state = RobotState::Idle;
    double charge = 0.0; ///< 0..1
    bool charging = false;
};

/// A whole plant in virtual time: robots, readers, floor and faults; commands in as bytes, reports out as
/// bytes. No clock, no socket. It advances in steps of 1 ms, so the same seed and the same bytes at the same
/// times give the same bytes, however the calls of advance() are grouped. Not thread-safe.
class Plant {
public:
    static constexpr Duration step = std::chrono::milliseconds(1);

    /// Places the AGVs at random (see randomStartPoses) and starts at `start`. NotFound: no room.
    static Result<Plant> create(PlantLayout layout, const PlantSettings& settings, Time start = {});

    /// Lets the plant run up to `now`, in whole steps; earlier times are ignored.
    void advance(Time now);
    Time now() const { return m_now; }
    const PlantLayout& layout() const { return m_layout; }

    // The functions below ignore ids that the plant does not have.

    /// Bytes of the console's TCP connection to a robot; they take effect at now().
    void receive(RobotId robot, std::span<const std::uint8_t> bytes);
    /// A console has connected anew. Losing one changes nothing: the robot goes on as commanded.
    void consoleConnected(RobotId robot);
    protocol::Bytes takeRobotFrames(RobotId robot);
    std::vector<protocol::Bytes> takeRobotDatagrams(RobotId robot);
    std::string takeReaderBytes(RobotId robot);
    bool takeBump(RobotId robot);

    std::vector<RobotTruth> truth() const;
    std::optional<RobotTruth> truth(RobotId robot) const;
    const TagFloor& floor() const { return m_floor; }

    // Faults.
    Result<void> killTag(TagUid uid) { return m_floor.kill(uid); }
    std::vector<TagUid> killRandomTags(std::size_t count) { return m_floor.killRandom(count, m_random); }
    Result<void> swapTags(TagUid first, TagUid second) { return m_floor.swap(first, second); }
    void setCharge(RobotId robot, double charge);      ///< 0..1
    void shiftAntenna(RobotId robot, Point2 offset_m); ///< forward, left; on top of the mounting error
    void setTableError(double share);                  ///< every reader; 0.08: all edges 8 % too far
    void setMissRate(double share);                    ///< every reader; 0..1
    void setSlip(RobotId robot, double share);         ///< 0..1 of the travel
    void failRobot(RobotId robot);
    void printGarbage(RobotId reader, std::size_t count);
    /// Why a trainer's hand cannot put the robot there: NotFound (no such robot), BadInput (beyond the edge
    /// of the plant, or another AGV stands there).
    Result<void> checkPlace(RobotId robot, Point2 centre) const;
    /// Anywhere, even into an obstacle.
    void placeRobot(RobotId robot, const Pose2& pose);
    /// Undoes every fault but charge and place.
    void restore();

private:
    struct Agv {
        Robot robot;
        RfidReader reader;
        Point2 antenna; ///< in the vehicle frame, true
        Point2 shift{}; ///< set by shiftAntenna
    };

    Plant(PlantLayout layout, const PlantSettings& settings, const std::vector<Pose2>& poses,
          SplitMix64 random, Time start);
    Agv* find(RobotId robot);
    void stepOnce();
    double clearance(std::size_t self, Point2 centre) const;
    static RobotTruth truthOf(const Agv& agv);

    PlantLayout m_layout;
    CollisionMap m_collisions;
    TagFloor m_floor;
    SplitMix64 m_random;
    std::vector<Agv> m_agvs;
    Time m_start;
    Time m_now;
};

} // namespace agv::simulation
