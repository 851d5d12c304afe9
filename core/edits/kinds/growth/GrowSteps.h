// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/growth/GrowCriteria.h"
#include "core/edits/kinds/growth/GrowGuard.h"

#include <optional>

namespace core {

struct GrowSteps {
    GrowCriteria criteria{};
    std::optional<int> steps{}; ///< none: to closure
    /// Voxels that the segment held before are told from those that grow over them, so that
    /// shrinking leaves them. False in sessions of schema 3 and before.
    bool tellsHeld = true;
    GrowGuard guard{};
};

} // namespace core
