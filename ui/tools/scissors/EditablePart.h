// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/EditableRange.h"
#include "core/volume/Volume.h"
#include "ui/geometry/ViewContext.h"

#include <QPainterPath>

namespace ui {

/// What of a path over the 3D view an edit with such a range may change, as far as a view through
/// all of the depth can tell: what lies over its box. Values and segments lie somewhere on each
/// line of sight; inside of no segment there is nothing.
[[nodiscard]] QPainterPath editablePart(const core::EditableRange& range, const QPainterPath& path,
    const core::VolumeGeometry& geometry, const ViewContext& view);

} // namespace ui
