// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "tests/support/scenes/TestVolumes.h"

#include <vector>

namespace test {

/// A volume, commands on it, and a rule for tracing the tolerances of label 2, with everything that
/// its growth may meet: other segments, members, barriers, painted and carved voxels, the border of
/// a box.
struct ToleranceScene {
    Codes codes;
    std::vector<core::EngineCommand> commands;
    core::ToleranceRule rule;
};
[[nodiscard]] ToleranceScene randomToleranceScene(const glm::ivec3& size, Random& random);

} // namespace test
