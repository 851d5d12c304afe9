// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Make what a sculpt layer has cut out a piece, which can be shown elsewhere.
struct CutPiece {
    int layer = 1; ///< id; not of another piece
    QString name{};
    std::optional<glm::dvec3> pivotLps{}; ///< none: the middle of the volume
};

} // namespace core
