// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/turn.h"

namespace agv {

const char* toText(TurnFlag flag)
{
    switch (flag) {
    case TurnFlag::Weak:
        return "weak";
    case TurnFlag::Ambiguous:
        return "ambiguous";
    case TurnFlag::FewReads:
        return "few_reads";
    case TurnFlag::WrongRotation:
        return "wrong_rotation";
    case TurnFlag::UnevenSteps:
        return "uneven_steps";
    case TurnFlag::PoorFit:
        return "poor_fit";
    case TurnFlag::NoReads:
        return "no_reads";
    case TurnFlag::NotConverged:
        return "not_converged";
    }
    return "unknown";
}

const char* toText(SolveMethod method)
{
    switch (method) {
    case SolveMethod::Auto:
        return "auto";
    case SolveMethod::Fast:
        return "fast";
    case SolveMethod::Classic:
        return "classic";
    }
    return "unknown";
}

const char* toText(Rotation rotation) { return rotation == Rotation::CounterClockwise ? "ccw" : "cw"; }

} // namespace agv
