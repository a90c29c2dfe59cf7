// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/turn_limits.h"

#include "core/units.h"

namespace agv::recording {

bool isStep(double rad) { return rad >= radFromDeg(0.999) && rad <= radFromDeg(180.001); }
bool isTurnTime_s(double s) { return s > 0.0 && s <= 3600.0; }
bool isTime_s(double s) { return s >= 0.0 && s <= 10.0 * 86400.0; }

std::optional<Rotation> parseRotation(std::string_view text)
{
    for (const Rotation rotation : {Rotation::CounterClockwise, Rotation::Clockwise}) {
        if (text == agv::toText(rotation))
            return rotation;
    }
    return std::nullopt;
}

std::optional<TurnKind> parseTurnKind(std::string_view text)
{
    for (const TurnKind kind : {TurnKind::Timed, TurnKind::Measured}) {
        if (text == toText(kind))
            return kind;
    }
    return std::nullopt;
}

const char* toText(TurnKind kind) { return kind == TurnKind::Timed ? "timed" : "measured"; }

} // namespace agv::recording
