// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/SparedVoxels.h"

#include <array>

namespace gpu {

void setSpared(Program& program, const core::SparedLabels& spared)
{
    std::array<unsigned, 8> words{};
    for (std::size_t label = 0; label < spared.labels.size(); ++label)
        words[label / 32] |= unsigned(spared.labels[label]) << (label % 32);
    program.set("sparesAny", spared.labels.any()).set("spared", std::span<const unsigned>(words));
}

void bindSpared(VoxelFields& fields, const core::SparedLabels& spared)
{
    fields.labels(spared.plane).bindUnit(2);
}

} // namespace gpu
