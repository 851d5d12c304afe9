// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <QString>

#include <cstddef>

namespace gpu {

/// How much graphics memory an open volume takes, without the pictures on their way to the views.
struct MemoryFormula {
    /// Bytes of the dense textures, which every volume of this size takes as soon as it is opened.
    [[nodiscard]] static std::size_t denseBytes(const glm::ivec3& size);
    /// The whole formula in one line of English, for `burin info --gl`.
    [[nodiscard]] static QString text();
};

} // namespace gpu
