// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace agv {

/// SI value of a number in a file: mm, ms and mm/s are thousandths of m, s and m/s.
double fromThousandths(long double number);

/// rad from degrees, in (-pi, pi].
double fromDegrees(long double degrees);

/// The shortest decimal that the functions above read back as exactly `si`, wider than double because
/// a length in m has bits that a double in mm cannot hold.
long double toThousandths(double si);
long double toDegrees(double rad);

/// The shortest text of a number, without an exponent where people would not write one. @pre finite
std::string decimalText(long double number);

} // namespace agv
