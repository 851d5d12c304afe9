// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewPlane.h"

namespace ui {

/// How a slice is laid on the screen: mirrored or not, and turned by quarters of a circle. All that
/// leads from pixels to places follows from the axes of the picture (of()), so tools, outlines and
/// orientation letters need not know of it.
struct SliceTurn {
    bool mirrored = false; ///< left and right are exchanged, before it is turned
    int quarters = 0; ///< clockwise, 0 … 3

    [[nodiscard]] bool isUpright() const { return !mirrored && quarters == 0; }
    /// The axes on the screen of a slice that has these axes when it is upright. The normal is
    /// right × down again, so it points to the other side if the slice is mirrored.
    [[nodiscard]] SliceAxes of(const SliceAxes& upright) const;

    /// After the picture on the screen was flipped or turned once more.
    [[nodiscard]] SliceTurn flippedLeftRight() const;
    [[nodiscard]] SliceTurn flippedTopBottom() const;
    [[nodiscard]] SliceTurn turnedClockwise() const;
    bool operator==(const SliceTurn&) const = default;
};

} // namespace ui
