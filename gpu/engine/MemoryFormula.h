// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <QString>

#include <cstddef>

namespace gpu {

/// What an open volume takes of graphics memory, beside pictures on their way to the views.
struct MemoryFormula {
    /// Of what every volume of this size takes at once.
    [[nodiscard]] static std::size_t denseBytes(const glm::ivec3& size);
    /// The whole in one line, in English.
    [[nodiscard]] static QString text();
};

} // namespace gpu
