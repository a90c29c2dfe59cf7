// SPDX-License-Identifier: GPL-3.0-or-later
#include "simserver/truth_log.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace agv::simserver {
namespace {

constexpr Duration period = std::chrono::milliseconds(50);

} // namespace

Result<TruthLog> TruthLog::open(const std::filesystem::path& path)
{
    std::ofstream file(path, std::ios::trunc);
    file << "time_s,robot,x_mm,y_mm,heading_deg,left_mm_s,right_mm_s,state,charge_percent\n" << std::flush;
    if (!file)
        return failure(ErrorCode::Io,
                       "cannot write the truth log " + path.string() + ": " + std::strerror(errno));
    return TruthLog(std::move(file));
}

void TruthLog::record(const simulation::Plant& plant)
{
    if (plant.now() < m_next)
        return;
    m_next = plant.now() + period;
    for (const simulation::RobotTruth& truth : plant.truth()) {
        std::array<char, 200> row{};
        std::snprintf(row.data(), row.size(), "%.3f,%d,%.2f,%.2f,%.3f,%.1f,%.1f,%d,%.3f\n",
                      secondsFrom(plant.now().time_since_epoch()), truth.id.number,
                      mmFromMetres(truth.pose.position.x), mmFromMetres(truth.pose.position.y),
                      degFromRad(truth.pose.heading), mmFromMetres(truth.wheels.left),
                      mmFromMetres(truth.wheels.right), static_cast<int>(truth.state), 100.0 * truth.charge);
        m_file << row.data();
    }
    m_file.flush();
}

} // namespace agv::simserver
