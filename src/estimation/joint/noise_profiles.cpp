// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/joint/noise_profiles.h"

#include <array>
#include <cmath>

namespace agv::estimation {

namespace {

struct DistanceNoise {
    const char* name;
    double sd_m;
    double outlier;
    double prior; ///< relative
};

struct ReadFailures {
    const char* name;
    double offByOne;
    double missed;
    double prior; ///< relative
};

constexpr std::array kDistances{
    DistanceNoise{"sharp", 0.0004, 1e-3, 1.0},  DistanceNoise{"fine", 0.0015, 3e-3, 1.0},
    DistanceNoise{"medium", 0.0030, 5e-3, 1.0}, DistanceNoise{"coarse", 0.0055, 1e-2, 0.7},
    DistanceNoise{"poor", 0.0090, 2e-2, 0.2},
};

constexpr std::array kFailures{
    ReadFailures{"clean", 0.02, 0.02, 1.0},       ReadFailures{"nearly clean", 0.20, 0.06, 1.0},
    ReadFailures{"few misses", 0.40, 0.12, 1.0},  ReadFailures{"misses", 0.45, 0.28, 1.0},
    ReadFailures{"many misses", 0.50, 0.50, 0.5}, ReadFailures{"hardly any reads", 0.50, 0.78, 0.25},
};

constexpr int kRows = static_cast<int>(kDistances.size());
constexpr int kColumns = static_cast<int>(kFailures.size());

} // namespace

NoiseProfiles::NoiseProfiles()
{
    double sum = 0.0;
    for (const DistanceNoise& distance : kDistances)
        for (const ReadFailures& failures : kFailures)
            sum += distance.prior * failures.prior;
    double cumulated = 0.0;
    for (const DistanceNoise& distance : kDistances) {
        for (const ReadFailures& failures : kFailures) {
            m_models.push_back({distance.sd_m, failures.offByOne, failures.missed, distance.outlier});
            m_logPriors.push_back(std::log(distance.prior * failures.prior / sum));
            cumulated += distance.prior * failures.prior / sum;
            m_cumulated.push_back(cumulated);
        }
    }
}

std::string NoiseProfiles::name(int profile) const
{
    return std::string(kDistances[static_cast<std::size_t>(profile / kColumns)].name) + ", " +
           kFailures[static_cast<std::size_t>(profile % kColumns)].name;
}

int NoiseProfiles::drawn(double share) const
{
    int profile = 0;
    while (profile + 1 < count() && m_cumulated[static_cast<std::size_t>(profile)] <= share)
        ++profile;
    return profile;
}

int NoiseProfiles::neighbour(int profile, int choice) const
{
    const int row = profile / kColumns + (choice == 0 ? 1 : choice == 1 ? -1 : 0);
    const int column = profile % kColumns + (choice == 2 ? 1 : choice == 3 ? -1 : 0);
    const bool inside = row >= 0 && row < kRows && column >= 0 && column < kColumns;
    return inside ? row * kColumns + column : -1;
}

} // namespace agv::estimation
