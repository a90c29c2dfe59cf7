// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file_units.h"

#include "core/units.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace agv {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64,
              "the exact round trip needs a wide long double");

constexpr long double degreesPerRadian = 180.0L / std::numbers::pi_v<long double>;

long double shortestReadAs(double si, long double wide, double (*read)(long double))
{
    std::array<char, 64> buffer{};
    for (int digits = 15; digits < std::numeric_limits<long double>::max_digits10; ++digits) {
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), wide,
                                       std::chars_format::scientific, digits - 1)
                             .ptr;
        long double candidate = wide;
        std::from_chars(buffer.data(), end, candidate);
        if (read(candidate) == si)
            return candidate;
    }
    return wide;
}

} // namespace

double fromThousandths(long double number) { return static_cast<double>(number / 1000.0L); }

double fromDegrees(long double degrees)
{
    const auto rad = static_cast<double>(degrees / degreesPerRadian);
    return rad > -std::numbers::pi && rad <= std::numbers::pi ? rad : wrapAngle(rad);
}

long double toThousandths(double si)
{
    return shortestReadAs(si, static_cast<long double>(si) * 1000.0L, fromThousandths);
}

long double toDegrees(double rad)
{
    return shortestReadAs(rad, static_cast<long double>(rad) * degreesPerRadian, fromDegrees);
}

std::string decimalText(long double number)
{
    if (number == 0.0L)
        return "0";
    const long double size = std::abs(number);
    const bool isPlain = size >= 1e-6L && size < 1e15L;
    std::array<char, 64> buffer{};
    char* const end = buffer.data() + buffer.size();
    const auto written = isPlain ? std::to_chars(buffer.data(), end, number, std::chars_format::fixed)
                                 : std::to_chars(buffer.data(), end, number);
    return {buffer.data(), written.ptr};
}

} // namespace agv
