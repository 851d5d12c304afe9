// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <cstdint>

namespace peer {

class RealSegment;

// What is read from a segment without changing labels: the volume masked by it, and how far it is
// from others.

/// The volume of which only the segment is left, another value standing everywhere else: all else
/// is carved, the carved volume exported, and the file read again; and ITK's MaskImageFilter.
struct ComparedVolume {
    static constexpr const char* peer = "ITK Mask";
    std::int64_t voxels = 0; ///< all of which were compared
    std::int64_t masked = 0; ///< where the other value stands
    std::int64_t differing = 0;
    /// The whole step: all else carved, and kept in the history.
    double stepMilliseconds = 0.0;
    /// The file written, read again and checked, as every export is. ITK writes none here.
    double exportMilliseconds = 0.0;
    double theirMilliseconds = 0.0;
};
/// Masks both ways, and takes it back. Errors: those of the edit and of the export.
[[nodiscard]] core::Result<ComparedVolume> compareMaskedVolume(RealSegment& segment);

/// The shortest distances between the surfaces of its islands, from each to the next smaller one;
/// to the largest those belong that are too small to be segments (leastIslandVoxels()). And those
/// of itkGap() (ItkDistances.h).
struct ComparedDistances {
    static constexpr const char* peer = "ITK Dilate, SignedMaurerDistanceMap";
    int pairs = 0; ///< 0: there is one island
    int differing = 0; ///< by more than both round
    double greatestMm = 0.0;
    double ourMilliseconds = 0.0; ///< of all pairs, the labels at hand
    double theirMilliseconds = 0.0;
};
/// Errors: those of segmentGap().
[[nodiscard]] core::Result<ComparedDistances> compareDistances(const RealSegment& segment);

} // namespace peer
