// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/edits/engine/CutFrames.h"
#include "core/sculpt/OutlineRaster.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// A mask plane with the area of a closed curve on it.
struct OutlinedPlane {
    CutFrame frame;
    OutlineRaster mask;
};

/// Makes them. Errors: those of cutFrame(), InvalidField (a curve that is too small).
/// @param options their maskReachMm is that of the curve
/// @param edit name of the edit, for errors; @param field that of its curve
[[nodiscard]] Result<OutlinedPlane> outlinedPlane(const std::vector<glm::dvec2>& outline,
    CutFrameOptions options, const Document& document, const QString& edit,
    const char* field = "polygonMm");

} // namespace core
