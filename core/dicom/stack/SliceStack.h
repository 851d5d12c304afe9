// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"
#include "core/volume/StudyListing.h"

#include <memory>
#include <vector>

namespace core {

/// The images of one volume, or of the first point in time of a series in time.
struct SliceStack {
    std::vector<ImageHeader> slices; ///< along row × column direction
    VolumeGeometry geometry;
    std::vector<VolumeProblem> problems;
    Clause part; ///< which part of a split series; empty for a whole one
    Clause time; ///< for a series in time: which point this is
    std::vector<SliceStack> laterTimes; ///< the other points in order, each on the same grid
    /// All images of the group, if several share a position and are not points in time; another
    /// choice among them is made from these (oneAtEveryPlace()). Null: there is no choice.
    std::shared_ptr<const std::vector<ImageHeader>> doubled{};
};

/// The result of sorting the images of one series.
struct StackSorting {
    std::vector<SliceStack> stacks;
    std::vector<ForeignObject> foreign; ///< images that are no slices of a volume
};

/// Sorts the images of one series into stacks by their contents, never by file name, instance
/// number or slice location. The steps are whyApart(), splitSeries(), sortIntoPlaces(),
/// dropDuplicates(), takeApartByQuantity(), findTimeAxis(), placeSlices(). Frames of a multi-frame
/// file are treated like images in single files.
[[nodiscard]] StackSorting sortIntoStacks(std::vector<ImageHeader> images);

/// The stack of images that are known to belong together, for example after some could not be
/// decoded.
[[nodiscard]] SliceStack stackOf(std::vector<ImageHeader> slices);

/// A stack with one image at each position: of several images, the one with the lowest or the
/// greatest instance number. Its problems still mention the others.
/// @param stack with `doubled` images
[[nodiscard]] SliceStack oneAtEveryPlace(const SliceStack& stack, bool last);

} // namespace core
