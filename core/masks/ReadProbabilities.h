// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/masks/MaskNote.h"
#include "core/volume/Volume.h"

namespace core {

/// A division that now contains its probability map and no longer names a file.
struct ReadProbabilities {
    DivideSegment edit;
    std::vector<MaskNote> notes; ///< what was resampled or assumed
};

/// Reads the probability map that a division names (DivideSegment::probabilityFile). NIfTI, NRRD
/// and MetaImage are recognised by file name and must contain one number per voxel, from 0 to 1, or
/// one byte per voxel from 0 to 255; any other file is read as a DICOM SEG of type FRACTIONAL
/// (PS3.3 C.8.20.2). If the grids differ, the nearest voxel decides (LatticeMap.h); voxels outside
/// the map get 0.
/// @param segment name of the segment that is divided; if a SEG contains several segments, the one
/// of this name is used
/// Any thread. Cost: the file, and one pass through the volume. Errors: those of the readers;
/// UnsupportedFormat (no probabilities, several layers or segments, or nothing inside the volume).
/// All name the file.
[[nodiscard]] Result<ReadProbabilities> readProbabilities(const DivideSegment& edit,
    const QString& segment, const Volume& volume, const Progress& progress);

} // namespace core
