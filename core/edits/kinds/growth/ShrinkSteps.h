// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace core {

/// Take back what growth added last, generation by generation.
struct ShrinkSteps {
    std::optional<int> steps{}; ///< none, or as many as there are: only the accepted seeds stay
};

} // namespace core
