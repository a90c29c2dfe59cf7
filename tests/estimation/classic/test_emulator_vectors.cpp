// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/classic/turn_vectors.h"

#include <gtest/gtest.h>

namespace agv {
namespace {

TEST(Emulator, readingsOfTheCoreRelationEqualEveryReferenceVector)
{
    int stops = 0;
    const auto vectors = test::readVector("emulator.json");
    for (const auto& vector : vectors["cases"]) {
        const std::vector<FloorTag> tags = test::fieldOf(vector["field"].get<std::string>());
        const Point2 centre{metresFromMm(vector["x"].get<double>()), metresFromMm(vector["y"].get<double>())};
        const double radius = metresFromMm(vector["R"].get<double>());
        for (std::size_t stop = 0; stop < vector["rows"].size(); ++stop) {
            const double bearing = radFromDeg(vector["bearing"].get<double>() +
                                              static_cast<double>(stop) * vector["step"].get<double>());
            const Point2 antenna = centre + radius * Point2{std::cos(bearing), std::sin(bearing)};
            auto readings = nlohmann::json::array();
            for (const FloorTag& tag : tags) {
                if (const auto rssi = rssiAt(seedRssiTable(), distance(tag.position, antenna)))
                    readings.push_back({tag.number, *rssi});
            }
            EXPECT_EQ(readings, vector["rows"][stop]) << "stop " << stop << " of " << vector["bearing"];
            ++stops;
        }
    }
    EXPECT_EQ(stops, 58);
}

TEST(RssiTable, equalsEveryReferenceVector)
{
    const auto vectors = test::readVector("rssi_table.json");
    for (const auto& vector : vectors["cases"]) {
        const auto rssi = rssiAt(seedRssiTable(), metresFromMm(vector[0].get<double>()));
        EXPECT_EQ(rssi.value_or(-1), vector[1].get<int>()) << vector;
    }
}

} // namespace
} // namespace agv
