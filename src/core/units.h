// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cmath>
#include <numbers>

namespace agv {

/// Monotonic instants. Tests make them from plain durations: Time{} + 30ms.
using Time = std::chrono::steady_clock::time_point;
using Duration = std::chrono::nanoseconds;

/// Inside the program everything is SI: metres, radians, seconds. These are the only conversions.
/// Metres by division: 43 mm is then exactly the literal 0.043, and borders of intervals can be compared.
constexpr double metresFromMm(double mm) { return mm / 1e3; }
constexpr double mmFromMetres(double m) { return m * 1e3; }
constexpr double radFromDeg(double deg) { return deg * (std::numbers::pi / 180.0); }
constexpr double degFromRad(double rad) { return rad * (180.0 / std::numbers::pi); }

inline double secondsFrom(Duration d) { return std::chrono::duration<double>(d).count(); }
inline Duration durationFromSeconds(double s)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s));
}

/// The same direction in (-pi, pi].
inline double wrapAngle(double rad)
{
    const double wrapped = std::remainder(rad, 2.0 * std::numbers::pi);
    return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

} // namespace agv
