// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/turn_parameters.h"

#include "core/units.h"

#include <cstdio>
#include <string>

namespace agv::procedure {
namespace {

std::string number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

struct Limit {
    const char* name;
    const char* unit;
    double value;
    double lowest;
    double highest;
};

Result<void> check(const Limit& limit)
{
    // Written so that a NaN fails too.
    if (limit.value >= limit.lowest && limit.value <= limit.highest)
        return {};
    return failure(ErrorCode::BadInput, std::string(limit.name) + " is " + number(limit.value) + " " +
                                            limit.unit + ": it must lie between " + number(limit.lowest) +
                                            " and " + number(limit.highest) + " " + limit.unit);
}

} // namespace

Result<void> validate(const TurnParameters& p)
{
    if (p.stopsPerTurn != 8 && p.stopsPerTurn != 12 && p.stopsPerTurn != 16) {
        return failure(ErrorCode::BadInput,
                       "Number of stops is " + std::to_string(p.stopsPerTurn) + ": it must be 8, 12 or 16");
    }
    const Limit limits[] = {
        {"Sleeptime", "ms", p.turnTime_s * 1e3, leastSleeptime_ms, mostSleeptime_ms},
        {"Wheel speed", "mm/s", mmFromMetres(p.wheelSpeed_m_s), mmFromMetres(leastTurnSpeed),
         mmFromMetres(mostTurnSpeed)},
        {"Settling time", "s", p.settle_s, 0.0, maxSettle_s},
        {"Shortest dwell", "s", p.minDwell_s, leastDwell_s, mostDwell_s},
        {"Longest dwell", "s", p.maxDwell_s, p.minDwell_s, mostDwell_s},
    };
    for (const Limit& limit : limits) {
        if (Result<void> result = check(limit); !result)
            return result;
    }
    return {};
}

} // namespace agv::procedure
