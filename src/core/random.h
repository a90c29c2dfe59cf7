// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace agv {

/// SplitMix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", 2014): the only source
/// of randomness of the program. The same seed gives the same numbers on every machine and compiler, so
/// simulations, solvers and tests can be repeated.
class SplitMix64 {
public:
    explicit SplitMix64(std::uint64_t seed) : m_state(seed) {}

    /// 64 random bits.
    std::uint64_t next()
    {
        m_state += 0x9E3779B97F4A7C15ULL;
        return mix(m_state);
    }

    /// In [0, 1), 53 bits.
    double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

    /// In [from, to).
    double uniform(double from, double to) { return from + (to - from) * uniform(); }

    /// Mean 0, standard deviation 1 (Box-Muller, cosine branch; takes two uniforms).
    double normal()
    {
        const double u1 = uniform();
        const double u2 = uniform();
        return std::sqrt(-2.0 * std::log1p(-u1)) * std::cos(2.0 * std::numbers::pi * u2);
    }

    /// Exponentially distributed with the given mean.
    double exponential(double mean) { return -mean * std::log1p(-uniform()); }

    /// A generator whose numbers are independent of this one's; `stream` tells apart the ones split off.
    SplitMix64 split(std::uint64_t stream) const { return SplitMix64(mix(m_state ^ mix(stream + 1))); }

    /// The bits of a hash of `value`: every input bit changes every output bit with odds of one half.
    static std::uint64_t mix(std::uint64_t value)
    {
        value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ULL;
        value = (value ^ (value >> 27)) * 0x94D049BB133111EBULL;
        return value ^ (value >> 31);
    }

private:
    std::uint64_t m_state;
};

} // namespace agv
