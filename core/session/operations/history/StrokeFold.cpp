// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/history/StrokeFold.h"

#include "core/sculpt/CutFrame.h"

#include <algorithm>
#include <utility>

namespace core {

void StrokeFold::lay(const StrokeCut& cut, int layer, bool restoring)
{
    for (const auto& [brick, bytes] : cut) {
        const auto found = bricks.find({Field::Coverage, std::uint8_t(layer), brick});
        if (found == bricks.end())
            continue;
        std::vector<std::uint8_t> held = found->second.bytes.read();
        const std::vector<std::uint8_t>& laid = bytes.read();
        if (restoring) {
            std::transform(held.begin(), held.end(), laid.begin(), held.begin(),
                [](std::uint8_t a, std::uint8_t b) { return refilled(a, b); });
            if (std::all_of(held.begin(), held.end(), [](std::uint8_t a) { return a == 0; }))
                held.clear(); // an empty brick has no bytes
        } else if (held.empty()) {
            held = laid;
        } else {
            std::transform(held.begin(), held.end(), laid.begin(), held.begin(),
                [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
        }
        found->second.bytes = std::move(held);
    }
}

} // namespace core
