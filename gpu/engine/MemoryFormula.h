// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <QString>

#include <cstddef>
#include <vector>

namespace gpu {

/// How much graphics memory an open volume takes, without the pictures on their way to the views.
struct MemoryFormula {
    /// A dense texture by its name, in English, and its bytes.
    struct Part {
        QString name;
        std::size_t bytes = 0;
    };
    /// The dense textures, which every volume of this size takes as soon as it is opened. A driver
    /// may refuse one that it finds too large, however much memory there is.
    [[nodiscard]] static std::vector<Part> denseParts(const glm::ivec3& size);
    /// The sum of their bytes.
    [[nodiscard]] static std::size_t denseBytes(const glm::ivec3& size);
    /// The whole formula in one line of English, for `burin info --gl`.
    [[nodiscard]] static QString text();
};

} // namespace gpu
