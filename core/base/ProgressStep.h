// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// What work that takes long is doing; ui/texts/ProgressTexts.h words it.
enum class ProgressStep : std::uint8_t {
    // Studies and sessions, read and written.
    ReadingHeaders,
    ReadingSlices,
    ReadingVoxels,
    Repairing,
    Unpacking,
    MakingDemonstration,
    CheckingSession,
    ReadingImages, ///< those that a session holds
    WritingImages, ///< into a session
    // Other nodes and servers.
    Searching,
    Downloading,
    Sending,
    // Masks taken in, surfaces, chunks.
    PlacingMask,
    FillingSurfaces,
    FittingSurface,
    FetchingValues, ///< of the box around a segment
    CuttingIntoPieces, ///< of which chunks are joined
    FindingLikelyParts,
    JoiningParts,
    ColouringChunks,
    // Segments as wholes.
    ReshapingSegment,
    // Exports.
    ReadingSourceHeaders,
    Measuring,
    TracingContours,
    WritingContours,
    MakingSurfaces,
    CheckingFrames,
    CheckingContours,
    CheckingSurfaces,
};

} // namespace core
