// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Rename, move, turn or zoom a piece; absent fields stay.
struct ChangePiece {
    int piece = 0; ///< id
    std::optional<QString> name{};
    std::optional<glm::dvec3> offsetMm{};
    std::optional<glm::dvec3> rotationDegrees{};
    std::optional<double> zoom{};
};

} // namespace core
