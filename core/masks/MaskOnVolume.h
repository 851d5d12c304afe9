// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/document/Document.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace core {

/// One segment of a mask's file, as voxels of the open volume. Segments may overlap.
struct MaskSegment {
    QString name;
    std::optional<std::uint32_t> rgb; ///< 0xRRGGBB; none: the file names none
    CodedConcept code;
    VoxelRuns voxels; ///< never none
};

/// What a mask's file holds, on the grid of a volume.
struct MaskOnVolume {
    std::vector<MaskSegment> segments; ///< in the file's order; at least one
    QStringList notes; ///< what was resampled, left out or taken for granted, one sentence each
};

/// Reads a mask of any format that is known: labels in NIfTI, NRRD (also .seg.nrrd) and MetaImage
/// files and surfaces in STL, OBJ, PLY and glTF by their names, else a DICOM SEG or RT Structure
/// Set. The nearest voxel decides where its grid is not the volume's (LatticeMap.h), of surfaces
/// the voxels' centres (SurfaceFill.h). The file is not kept open. Any thread. Errors: those of
/// the formats' readers; UnsupportedFormat (no labels, no segment, nothing of it inside the
/// volume). All name the file.
[[nodiscard]] Result<MaskOnVolume> readMask(
    const QString& path, const Volume& volume, const Progress& progress);

/// The names that files of masks have, as a file dialog wants them: "*.nii", …
[[nodiscard]] QStringList maskNamePatterns();

/// Whether a DICOM SOP class is one of masks.
[[nodiscard]] bool isMaskClass(const QString& sopClassUid);

} // namespace core
