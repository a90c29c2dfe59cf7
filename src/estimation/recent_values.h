// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace agv::estimation {

/// The last `Capacity` values, in no particular order; never allocates.
template<typename T, std::size_t Capacity>
class RecentValues {
public:
    void add(const T& value)
    {
        m_values[m_next] = value;
        m_next = (m_next + 1) % Capacity;
        m_size += m_size < Capacity ? 1 : 0;
    }
    void clear() { m_size = m_next = 0; }
    std::size_t size() const { return m_size; }
    std::span<const T> values() const { return {m_values.data(), m_size}; }

private:
    std::array<T, Capacity> m_values{};
    std::size_t m_next = 0;
    std::size_t m_size = 0;
};

} // namespace agv::estimation
