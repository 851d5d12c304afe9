// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "tests/support/scenes/TestVolumes.h"

#include <vector>

namespace test {

/// A volume, what is done to it, and a rule to trace label 2 by: with everything that a growth of
/// it may meet (other segments, members, barriers, what is painted, carved, out of the box).
struct ToleranceScene {
    Codes codes;
    std::vector<core::EngineCommand> commands;
    core::ToleranceRule rule;
};
[[nodiscard]] ToleranceScene randomToleranceScene(const glm::ivec3& size, Random& random);

} // namespace test
