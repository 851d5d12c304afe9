// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Piece.h"

#include <QString>

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Show a segment as a piece of its own, besides where it is.
struct PastePiece {
    int segment = 0; ///< label
    QString name{};
    std::optional<glm::dvec3> pivotLps{};
    PiecePose pose{};
};

} // namespace core
