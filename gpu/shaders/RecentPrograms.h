// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace gpu {

/// Programs that are compiled for many kinds of work, of which only those used last are kept: with
/// some drivers a program takes megabytes, and hundreds of kinds can be asked for in a day. Whoever
/// works with programs holds them, so that none is deleted in use. Engine thread only.
template <class Kind, class Programs, std::size_t most = 8> class RecentPrograms {
public:
    /// @param make compiles them: a std::shared_ptr. Cost: that of compiling, for a kind that is
    /// not among the last ones.
    template <class Make>
    [[nodiscard]] std::shared_ptr<Programs> of(const Kind& kind, const Make& make)
    {
        const auto known = std::find_if(
            m_known.begin(), m_known.end(), [&](const auto& each) { return each.first == kind; });
        if (known != m_known.end()) {
            std::rotate(m_known.begin(), known, known + 1);
            return m_known.front().second;
        }
        m_known.emplace(m_known.begin(), kind, make());
        if (m_known.size() > most)
            m_known.pop_back();
        return m_known.front().second;
    }
    [[nodiscard]] std::size_t count() const { return m_known.size(); }

private:
    std::vector<std::pair<Kind, std::shared_ptr<Programs>>> m_known; ///< the last used one first
};

} // namespace gpu
