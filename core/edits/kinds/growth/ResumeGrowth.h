// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace core {

/// Go on with the growth before, by its own criteria. Kept as the GrowSteps that it was.
struct ResumeGrowth {
    std::optional<int> steps{}; ///< none: to closure
};

} // namespace core
