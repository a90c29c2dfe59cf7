// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sleeptime_file.h"

#include "core/plant_file.h"

#include <algorithm>
#include <string>
#include <utility>

namespace agv::app {

Result<double> writeSleeptime(const std::filesystem::path& path, RobotId robot, double turnTime_s,
                              double turnSpeed_m_s)
{
    const Result<PlantDocument> document = PlantDocument::fromFile(path);
    if (!document)
        return std::unexpected(document.error());
    PlantLayout layout = document->layout();
    const auto agv = std::find_if(layout.agvs.begin(), layout.agvs.end(),
                                  [robot](const AgvConfig& config) { return config.id == robot; });
    if (agv == layout.agvs.end())
        return failure(ErrorCode::NotFound, path.string() + ": not written; it no longer has an AGV " +
                                                std::to_string(robot.number));
    const double before_s = std::exchange(agv->turnTime_s, turnTime_s);
    agv->turnSpeed_m_s = turnSpeed_m_s;
    if (const Result<void> written = writePlantFile(path, layout, &*document); !written)
        return std::unexpected(written.error());
    return before_s;
}

} // namespace agv::app
