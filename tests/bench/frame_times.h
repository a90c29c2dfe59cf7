// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

namespace agv::bench {

/// CPU time of this process, ms.
inline double cpu_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Runs `frame` so often and prints median and p99 of its wall time and the mean of its CPU time.
inline void reportFrames(const char* name, int frames, const std::function<void(int)>& frame)
{
    std::vector<double> times_ms;
    const double cpuBefore_ms = cpu_ms();
    for (int i = 0; i < frames; ++i) {
        const auto start = std::chrono::steady_clock::now();
        frame(i);
        times_ms.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    const double cpu = (cpu_ms() - cpuBefore_ms) / frames;
    std::sort(times_ms.begin(), times_ms.end());
    const auto at = [&](double part) {
        return times_ms[static_cast<std::size_t>(part * static_cast<double>(times_ms.size() - 1))];
    };
    std::printf("%-58s median %6.2f ms   p99 %6.2f ms   CPU %6.2f ms   (%d frames)\n", name, at(0.5),
                at(0.99), cpu, frames);
}

} // namespace agv::bench
