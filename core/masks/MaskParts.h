// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/masks/MaskOnVolume.h"

namespace core {

// The formats, for MaskOnVolume.cpp.

/// What became of voxels on their way.
struct MaskFit {
    bool oneToOne = false;
    std::uint64_t labelled = 0; ///< voxels in the file
    std::uint64_t outside = 0; ///< of these, outside the volume
    double labelledMl = 0.0; ///< in the file
    double takenMl = 0.0; ///< in the volume
};
/// Sentences on it; none where all is as in the file.
[[nodiscard]] QStringList notesOn(const MaskFit& fit);

/// What a mask says of whom and where it is, where the study says otherwise. Names nobody.
[[nodiscard]] QStringList notesOnOrigin(
    const QString& patientId, const QString& frameOfReferenceUid, const Volume& volume);

[[nodiscard]] Result<MaskOnVolume> readLabelMask(
    const QString& path, const Volume& volume, const Progress& progress);
[[nodiscard]] Result<MaskOnVolume> readSegMask(
    const QString& path, const Volume& volume, const Progress& progress);

[[nodiscard]] Result<MaskOnVolume> readContourMask(
    const QString& path, const Volume& volume, const Progress& progress);
[[nodiscard]] Result<MaskOnVolume> readSurfaceMask(
    const QString& path, const Volume& volume, const Progress& progress);

/// For a segment that its file gives no name: "liver.nii.gz" → "liver".
[[nodiscard]] QString maskNameOf(const QString& path);
/// "12.3 mL"
[[nodiscard]] QString inMl(double ml);

/// mL that voxels of a volume take up.
[[nodiscard]] double millilitres(std::uint64_t voxels, const VolumeGeometry& geometry);

} // namespace core
