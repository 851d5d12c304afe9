// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewPlane.h"

namespace ui {

/// How the picture of a slice lies on the screen: mirrored or not, and rotated by quarter turns.
/// of() applies this to the axes of the slice. Everything else (tools, outlines, orientation
/// letters) works with these axes and need not know about it.
struct SliceTurn {
    bool mirrored = false; ///< left and right are exchanged; this comes before the rotation
    int quarters = 0; ///< quarter turns clockwise, 0 … 3

    [[nodiscard]] bool isUpright() const { return !mirrored && quarters == 0; }
    /// Returns the axes of the slice as it lies on the screen.
    /// @param upright the axes of the slice when it is upright
    /// @return the normal is again right × down, so it points to the other side if the slice is
    /// mirrored
    [[nodiscard]] SliceAxes of(const SliceAxes& upright) const;

    /// The state after flipping or rotating the picture as it is seen on the screen.
    [[nodiscard]] SliceTurn flippedLeftRight() const;
    [[nodiscard]] SliceTurn flippedTopBottom() const;
    [[nodiscard]] SliceTurn turnedClockwise() const;
    bool operator==(const SliceTurn&) const = default;
};

} // namespace ui
