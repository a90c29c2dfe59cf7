// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verdict_text.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace agv::app {
namespace {

const char* advice(TurnFlag flag)
{
    switch (flag) {
    case TurnFlag::Weak:
        return "the uncertainty is too large for driving";
    case TurnFlag::Ambiguous:
        return "a second pose explains the reads nearly as well";
    case TurnFlag::FewReads:
        return "there were few reads";
    case TurnFlag::WrongRotation:
        return "the robot turned against the commanded direction";
    case TurnFlag::UnevenSteps:
        return "the steps were uneven";
    case TurnFlag::PoorFit:
        return "the reads contradict the plant file";
    case TurnFlag::NoReads:
        return "no floor tag was read";
    case TurnFlag::NotConverged:
        return "the solver did not come to an end";
    }
    return "";
}

std::string flagText(const std::vector<TurnFlag>& flags)
{
    std::string text;
    for (const TurnFlag flag : flags)
        text += (text.empty() ? " Mind: " : "; ") + std::string(advice(flag));
    return text.empty() ? text : text + ".";
}

std::string sleeptimeText(const TurnEstimate& estimate)
{
    if (!estimate.suggestedTurnTime_s)
        return {};
    return " Suggested sleeptime: " + thousands(*estimate.suggestedTurnTime_s * 1e3) + " ms, plus or minus " +
           thousands(std::ceil(1.96 * estimate.suggestedTurnTimeSd_s * 1e3)) + " ms.";
}

} // namespace

std::string thousands(double value)
{
    std::string digits = std::to_string(std::llround(std::abs(value)));
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), 1, ',');
    return (std::llround(value) < 0 ? "-" : "") + digits;
}

Uncertainty uncertaintyOf(const TurnEstimate& estimate)
{
    const double xx = estimate.covariance[0];
    const double xy = 0.5 * (estimate.covariance[1] + estimate.covariance[3]);
    const double yy = estimate.covariance[4];
    const double largest = 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy);
    constexpr double chiSquare95 = 5.991; // two degrees of freedom
    return {std::sqrt(std::max(0.0, chiSquare95 * largest)), 1.96 * estimate.lastHeadingSd};
}

std::string verdictText(const std::string& label, const TurnSnapshot& turn)
{
    if (turn.phase != TurnPhase::Finished || !turn.result)
        return label + ": no pose. " + turn.message + ".";
    const TurnEstimate& estimate = *turn.result;
    if (!estimate.valid) {
        return label + ": no pose (" + estimate.status + ")." + flagText(estimate.flags) +
               " Check that the AGV stands on floor tags and read it again.";
    }
    const Uncertainty uncertainty = uncertaintyOf(estimate);
    return label + " stands at " + thousands(mmFromMetres(estimate.pose.position.x)) + " mm, " +
           thousands(mmFromMetres(estimate.pose.position.y)) + " mm, facing " +
           thousands(degFromRad(estimate.pose.heading)) + " degrees; plus or minus " +
           thousands(std::ceil(mmFromMetres(uncertainty.position_m))) + " mm, " +
           thousands(std::ceil(degFromRad(uncertainty.heading))) + " degrees." + flagText(estimate.flags) +
           sleeptimeText(estimate);
}

} // namespace agv::app
