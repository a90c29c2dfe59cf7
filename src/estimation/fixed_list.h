// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace agv::estimation {

/// A vector that never allocates: at most Capacity elements, further ones are dropped and counted.
template<typename T, std::size_t Capacity>
class FixedList {
public:
    void clear() { m_size = 0; }
    /// False when the list is full.
    bool add(const T& value)
    {
        if (m_size == Capacity) {
            ++m_dropped;
            return false;
        }
        m_items[m_size++] = value;
        return true;
    }

    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }
    std::size_t dropped() const { return m_dropped; }
    static constexpr std::size_t capacity() { return Capacity; }

    T& operator[](std::size_t i) { return m_items[i]; }
    const T& operator[](std::size_t i) const { return m_items[i]; }
    T* data() { return m_items.data(); }
    const T* data() const { return m_items.data(); }
    T* begin() { return m_items.data(); }
    T* end() { return m_items.data() + m_size; }
    const T* begin() const { return m_items.data(); }
    const T* end() const { return m_items.data() + m_size; }

private:
    std::array<T, Capacity> m_items{};
    std::size_t m_size = 0;
    std::size_t m_dropped = 0;
};

} // namespace agv::estimation
