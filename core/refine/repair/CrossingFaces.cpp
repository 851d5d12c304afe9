// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/CrossingFaces.h"

#include "core/base/ParallelFor.h"

#include <algorithm>
#include <array>

namespace core {

std::vector<CrossingFaces> collectCrossings(std::size_t places,
    const std::function<void(
        std::size_t begin, std::size_t end, std::vector<CrossingFaces>& found)>& look)
{
    constexpr std::size_t few = 256; // not worth a thread
    constexpr int shares = 16;
    std::vector<CrossingFaces> all;
    if (places < few) {
        look(0, places, all);
    } else {
        std::array<std::vector<CrossingFaces>, shares> found;
        parallelFor(shares, [&](int share) {
            look(places * std::size_t(share) / shares, places * (std::size_t(share) + 1) / shares,
                found[std::size_t(share)]);
        });
        for (const auto& part : found)
            all.insert(all.end(), part.begin(), part.end());
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

} // namespace core
