// SPDX-License-Identifier: Apache-2.0
#include "core/brick/LabelRuns.h"

namespace core {

VoxelRuns labelRuns(std::span<const std::uint8_t> labels, std::uint8_t label)
{
    VoxelRuns runs;
    for (std::size_t at = 0; at < labels.size();) {
        if (labels[at] != label) {
            ++at;
            continue;
        }
        const std::size_t first = at;
        while (at < labels.size() && labels[at] == label)
            ++at;
        runs.append(first, at - first);
    }
    return runs;
}

} // namespace core
