// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/ImageHeader.h"
#include "core/volume/StudyListing.h"

#include <vector>

namespace core {

/// Images that lie behind each other: one volume.
struct SliceStack {
    std::vector<ImageHeader> slices; ///< along row × column direction
    VolumeGeometry geometry;
    std::vector<VolumeProblem> problems;
    QString part; ///< which part of a split series, in words; empty for a whole one
};

/// What became of the images of one series.
struct StackSorting {
    std::vector<SliceStack> stacks;
    std::vector<ForeignObject> foreign; ///< images that are no slices of a volume
};

/// Sorts the images of one series into stacks by what they show, never by file name, instance
/// number or slice location (DICOM.md 1.2 to 1.4): localizers and images without a place apart,
/// duplicates dropped with a note; split by frame of reference, size, plane and pixel spacing;
/// images at one position told apart as phases; ordered by position along the normal.
[[nodiscard]] StackSorting sortIntoStacks(std::vector<ImageHeader> images);

/// The stack of images already known to belong together, e.g. after some could not be decoded.
[[nodiscard]] SliceStack stackOf(std::vector<ImageHeader> slices);

} // namespace core
