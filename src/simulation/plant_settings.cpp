// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant_settings.h"

#include "simulation/battery.h"

namespace agv::simulation {

PlantSettings idealSettings(std::uint64_t seed)
{
    PlantSettings settings;
    settings.seed = seed;
    settings.charge = nominalCharge(settings.drive);
    settings.drive.imbalanceSd = 0.0;
    settings.drive.slipNoise_sqrtM = 0.0;
    settings.drive.encoderScaleSd = 0.0;
    ReaderModel& reader = settings.reader;
    reader.slotJitter_s = 0.0;
    reader.missRate = 0.0;
    reader.deafRate = 0.0;
    reader.incompleteRate = 0.0;
    reader.noiseRate = 0.0;
    reader.placeNoiseRate = 0.0;
    reader.lateRate = 0.0;
    reader.antennaErrorSd_m = 0.0;
    reader.tagErrorSd_m = 0.0;
    reader.tableScaleSd = 0.0;
    reader.tableEdgeSd_m = 0.0;
    return settings;
}

} // namespace agv::simulation
