// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"
#include "core/volume/StudyListing.h"

#include <memory>
#include <vector>

namespace core {

/// Images that lie behind each other: one volume, or the first point in time of one.
struct SliceStack {
    std::vector<ImageHeader> slices; ///< along row × column direction
    VolumeGeometry geometry;
    std::vector<VolumeProblem> problems;
    QString part; ///< which part of a split series, in words; empty for a whole one
    QString time; ///< of a series in time: which point this is, in words
    std::vector<SliceStack> laterTimes; ///< the other points in order, each on the same grid
    /// All images of the group it came from, where several share a place and are no points in time:
    /// what another choice among them is made of (oneAtEveryPlace()). Null: there is no choice.
    std::shared_ptr<const std::vector<ImageHeader>> doubled{};
};

/// What became of the images of one series.
struct StackSorting {
    std::vector<SliceStack> stacks;
    std::vector<ForeignObject> foreign; ///< images that are no slices of a volume
};

/// Sorts the images of one series into stacks by what they show, never by file name, instance
/// number or slice location (DICOM.md 1.2 to 1.4): whyApart() first, then splitSeries(),
/// sortIntoPlaces(), dropDuplicates(), takeApartByQuantity(), findTimeAxis(), placeSlices(). Frames
/// of a multi-frame file are images like those of single files.
[[nodiscard]] StackSorting sortIntoStacks(std::vector<ImageHeader> images);

/// The stack of images already known to belong together, e.g. after some could not be decoded.
[[nodiscard]] SliceStack stackOf(std::vector<ImageHeader> slices);

/// One image at every place of a stack's group: of several the one with the least instance number,
/// or the greatest; its problems name them still. @param stack with `doubled` images
[[nodiscard]] SliceStack oneAtEveryPlace(const SliceStack& stack, bool last);

} // namespace core
