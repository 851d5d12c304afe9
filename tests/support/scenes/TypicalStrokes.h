// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/BrushPath.h"

namespace test {

/// A typical stroke of paint of a radiologist: sixty dabs of an 8 mm ball or disc, 3 mm apart, in
/// three bends across about 60 × 40 mm of an axial slice.
[[nodiscard]] core::Edit typicalPaintStroke(
    int segment, const glm::dvec3& middleLps, core::BrushPath::Shape shape);

} // namespace test
