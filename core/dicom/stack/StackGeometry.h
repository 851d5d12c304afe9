// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/stack/SliceStack.h"

#include <vector>

namespace core {

/// Sets the geometry of a stack whose slices are in order, and the problems that positions show:
/// missing slices, uneven spacing, tilt, assumed spacing (DICOM.md 1.4).
///
/// The affine runs from the first slice's position to the last one's; it may be sheared. Where
/// it does not meet every slice (0.01 mm, 1 % of the distance), slicePositions hold them all.
void placeSlices(SliceStack& stack);

/// Largest distance of a slice's position from the straight line through the first and the last,
/// measured across the normal.
[[nodiscard]] double sidewaysDriftMm(const SliceStack& stack);

/// The problem that names slices left out because their pixel data are damaged.
/// @param names as imageName() has them
[[nodiscard]] VolumeProblem damagedSlices(const QStringList& names);

/// A slice and why it could not be decoded, for people.
struct UndecodedSlice {
    int number = 0; ///< in its stack, from 1
    QString image; ///< as imageName() has it
    QString reason;
};
/// The problem that names slices left out because decoding them failed; of many the first.
[[nodiscard]] VolumeProblem undecodedSlices(const std::vector<UndecodedSlice>& slices);

/// Name of the image's file, and of several frames which it is, for people.
[[nodiscard]] QString imageName(const ImageHeader& image);

} // namespace core
