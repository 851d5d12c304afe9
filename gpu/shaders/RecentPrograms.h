// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace gpu {

/// A cache of the programs used last, for programs with many variants. With some drivers a program
/// takes megabytes, and hundreds of variants may be asked for in a day. Users hold the programs by
/// shared pointer, so none is deleted while in use. Engine thread only.
template <class Kind, class Programs, std::size_t most = 8> class RecentPrograms {
public:
    /// Returns the programs of a variant. Cost: that of compiling if the variant is not among the
    /// last @p most.
    /// @param make compiles them and returns a std::shared_ptr
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
