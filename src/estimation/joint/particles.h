// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace agv::estimation {

/// A population of hypotheses, one array per quantity so that the compiler can work on several at once.
struct Particles {
    Particles(std::size_t count, std::size_t stops)
        : x(count),
          y(count),
          driftX(count),
          driftY(count),
          radius(count),
          step(count),
          logScale(count),
          logJitter(count),
          profile(count),
          bearing(count * stops),
          m_stops(stops)
    {}

    std::size_t size() const { return x.size(); }
    std::size_t stops() const { return m_stops; }
    float* bearingsAt(std::size_t stop) { return bearing.data() + stop * size(); }
    const float* bearingsAt(std::size_t stop) const { return bearing.data() + stop * size(); }
    float& bearingOf(std::size_t stop, std::size_t i) { return bearing[stop * size() + i]; }
    float bearingOf(std::size_t stop, std::size_t i) const { return bearing[stop * size() + i]; }

    /// How much of the drift has happened at a stop, relative to the middle of the turn: -1/2 to 1/2.
    float drifted(std::size_t stop) const
    {
        return m_stops > 1 ? static_cast<float>(stop) / static_cast<float>(m_stops - 1) - 0.5F : 0.0F;
    }

    /// Copies particle `from` of `source` to place `to`.
    void take(std::size_t to, const Particles& source, std::size_t from)
    {
        x[to] = source.x[from];
        y[to] = source.y[from];
        driftX[to] = source.driftX[from];
        driftY[to] = source.driftY[from];
        radius[to] = source.radius[from];
        step[to] = source.step[from];
        logScale[to] = source.logScale[from];
        logJitter[to] = source.logJitter[from];
        profile[to] = source.profile[from];
        for (std::size_t k = 0; k < m_stops; ++k)
            bearingOf(k, to) = source.bearingOf(k, from);
    }

    /// Adds the particles of `other`, which has the same stops.
    void append(const Particles& other)
    {
        const std::size_t before = size();
        Particles joined(before + other.size(), m_stops);
        for (std::size_t i = 0; i < joined.size(); ++i)
            joined.take(i, i < before ? *this : other, i < before ? i : i - before);
        *this = std::move(joined);
    }

    std::vector<float> x, y;   ///< centre in the middle of the turn, m, local frame
    std::vector<float> driftX; ///< motion of the centre from the first to the last stop, m
    std::vector<float> driftY;
    std::vector<float> radius;    ///< m
    std::vector<float> step;      ///< rad, signed
    std::vector<float> logScale;  ///< log of true distances / table distances
    std::vector<float> logJitter; ///< log of the sd of single steps around `step`, rad
    std::vector<int> profile;     ///< index of the noise model
    std::vector<float> bearing;   ///< rad, [stop][particle], not wrapped along the stops

private:
    std::size_t m_stops;
};

} // namespace agv::estimation
