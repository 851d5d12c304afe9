// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpu {

/// The bricks of which a kernel says what a flag stands for.
/// @param found what it says of each, by place
[[nodiscard]] inline std::vector<std::uint32_t> chosen(const std::vector<std::uint32_t>& bricks,
    const std::vector<std::uint32_t>& found, std::uint32_t flag)
{
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        if ((found[i] & flag) != 0)
            result.push_back(bricks[i]);
    }
    return result;
}

} // namespace gpu
