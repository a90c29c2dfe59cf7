// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/plant_layout.h"
#include "core/snapshot.h"

#include <vector>

namespace agv::model {

/// One thing that has to be in order at the start of a shift.
struct ShiftCheck {
    bool passed = false;
    QString what;   ///< "AGV 2: battery"
    QString cause;  ///< what was found, one sentence; of a check that passed, too
    QString remedy; ///< what to do; empty when it passed
};

/// What the snapshot does not tell.
struct ShiftFacts {
    qint64 freeDisk_bytes = 0; ///< where sleeptimes and recordings are kept
};

/// The checks at the start of a shift. Pure: the same plant, snapshot and facts give the same answers, in the
/// language of the program.
class ShiftChecks {
    Q_DECLARE_TR_FUNCTIONS(agv::model::ShiftChecks)
public:
    static constexpr double enoughCharge = 0.30; ///< share of the capacity, for some hours of driving
    static constexpr double freshFor_s = 2.0;
    static constexpr qint64 enoughDisk_bytes = 1'000'000'000;
    /// A sleeptime is doubted when its turn would differ by more than this share from that of the geometry.
    static constexpr double sleeptimeTolerance = 0.25;

    static std::vector<ShiftCheck> of(const PlantLayout& plant, const PlantSnapshot& snapshot,
                                      const ShiftFacts& facts);

private:
    static ShiftCheck plantFile(const PlantLayout& plant);
    static ShiftCheck robotPort(const PlantSnapshot& snapshot);
    static ShiftCheck reader(const AgvSnapshot& agv);
    static ShiftCheck robot(const AgvSnapshot& agv);
    static ShiftCheck battery(const AgvSnapshot& agv);
    static ShiftCheck floorTags(const AgvSnapshot& agv, const TagMap& tags);
    static ShiftCheck sleeptime(const AgvSnapshot& agv, const AgvConfig& config);
    static ShiftCheck uwbUnit(const PlantSnapshot& snapshot);
    static ShiftCheck anchors(const PlantLayout& plant, const PlantSnapshot& snapshot);
    static ShiftCheck disk(const ShiftFacts& facts);
};

} // namespace agv::model
