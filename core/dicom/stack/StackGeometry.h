// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/stack/SliceStack.h"

#include <vector>

namespace core {

/// Sets the geometry of a stack whose slices are in order, and adds the problems that follow from
/// their positions: missing slices, uneven spacing, positions that wander, tilt, assumed spacing.
///
/// The affine leads from the first slice's position to that of the last and may be sheared. If it
/// does not fit every slice (0.01 mm, 1 % of the distance), slicePositions contain all of them.
void placeSlices(SliceStack& stack);

/// Largest distance of a slice's position from the straight line through the first and the last,
/// measured across the normal.
[[nodiscard]] double sidewaysDriftMm(const SliceStack& stack);

/// The problem that lists slices left out because their pixel data are damaged.
/// @param names from imageName()
[[nodiscard]] VolumeProblem damagedSlices(const QStringList& names);

/// A slice, and why it could not be decoded, for the user.
struct UndecodedSlice {
    int number = 0; ///< in its stack, from 1
    QString image; ///< from imageName()
    QString reason;
};
/// The problem that lists slices left out because decoding failed; if there are many, the first
/// ones.
[[nodiscard]] VolumeProblem undecodedSlices(const std::vector<UndecodedSlice>& slices);

/// The file name of an image, with the frame number if there are several, for the user.
[[nodiscard]] QString imageName(const ImageHeader& image);

} // namespace core
