// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// The step that a long-running task is in, as it reports it to its Progress.
/// ui/texts/ProgressTexts.h puts it into words.
enum class ProgressStep : std::uint8_t {
    // Reading and writing studies and sessions.
    ReadingHeaders,
    ReadingSlices,
    ReadingVoxels,
    Repairing,
    Unpacking,
    MakingDemonstration,
    CheckingSession,
    ReadingImages, ///< the images that a session file contains
    WritingImages, ///< into a session file
    // Talking to other DICOM nodes and servers.
    Searching,
    Downloading,
    Sending,
    // Importing masks, refining surfaces, dividing segments into chunks.
    PlacingMask,
    FillingSurfaces,
    FittingSurface,
    FetchingValues, ///< the voxel values of the box around a segment
    CuttingIntoPieces, ///< the small pieces from which chunks are joined
    FindingLikelyParts,
    JoiningParts,
    ColouringChunks,
    // Working out edits of whole segments.
    ReshapingSegment,
    // Exporting, and checking what was written.
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
