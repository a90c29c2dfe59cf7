// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace agv::recording {

/// A number for files, whatever the locale: ten significant digits, no more than needed, '.' as the decimal
/// point. Empty for what is not finite.
std::string numberText(double value);

/// The shortest text that reads back as exactly `value`, '.' as the decimal point. Empty for what is not
/// finite.
std::string exactNumberText(double value);

} // namespace agv::recording
