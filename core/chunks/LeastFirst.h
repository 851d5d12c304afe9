// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace core {

/// A min-heap with four children per node, compared with `>`. With four it touches about half as
/// many places in memory as with two, which makes it faster for large queues.
template <class Item> class LeastFirst {
public:
    [[nodiscard]] bool empty() const { return m_items.empty(); }
    [[nodiscard]] const Item& top() const { return m_items.front(); }
    void push(const Item& item)
    {
        std::size_t place = m_items.size();
        m_items.push_back(item);
        while (place > 0) {
            const std::size_t parent = (place - 1) / branches;
            if (!(m_items[parent] > item))
                break;
            m_items[place] = m_items[parent];
            place = parent;
        }
        m_items[place] = item;
    }
    [[nodiscard]] Item pop()
    {
        const Item first = m_items.front();
        const Item last = m_items.back();
        m_items.pop_back();
        if (m_items.empty())
            return first;
        std::size_t place = 0;
        while (true) {
            const std::size_t begin = branches * place + 1;
            if (begin >= m_items.size())
                break;
            const std::size_t end = std::min(begin + branches, m_items.size());
            std::size_t least = begin;
            for (std::size_t child = begin + 1; child < end; ++child) {
                if (m_items[least] > m_items[child])
                    least = child;
            }
            if (!(last > m_items[least]))
                break;
            m_items[place] = m_items[least];
            place = least;
        }
        m_items[place] = last;
        return first;
    }

private:
    static constexpr std::size_t branches = 4;
    std::vector<Item> m_items;
};

} // namespace core
