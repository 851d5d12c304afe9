// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpu {

/// The bricks for which a kernel has set a flag.
/// @param found the flags that the kernel has set, one entry for each brick
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
