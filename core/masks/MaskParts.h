// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/masks/MaskOnVolume.h"

namespace core {

// The readers of the formats, for MaskOnVolume.cpp.

/// How many voxels of a file could be used.
struct MaskFit {
    bool oneToOne = false;
    std::uint64_t labelled = 0; ///< voxels in the file
    std::uint64_t outside = 0; ///< of these, voxels outside the volume
    double labelledMl = 0.0; ///< in the file
    double takenMl = 0.0; ///< in the volume
};
/// A note on the difference; none if everything is as in the file.
[[nodiscard]] std::vector<MaskNote> notesOn(const MaskFit& fit);

/// Notes if the mask's patient or frame of reference differs from the study's.
[[nodiscard]] std::vector<MaskNote> notesOnOrigin(
    const QString& patientId, const QString& frameOfReferenceUid, const Volume& volume);

[[nodiscard]] Result<MaskOnVolume> readLabelMask(
    const QString& path, const Volume& volume, const Progress& progress);
[[nodiscard]] Result<MaskOnVolume> readSegMask(
    const QString& path, const Volume& volume, const Progress& progress);

/// A probability map on the volume's grid.
struct ProbabilitiesOnVolume {
    std::vector<std::uint8_t> probabilities; ///< ProbabilityMap, a byte a voxel
    std::vector<MaskNote> notes;
};
/// Reads the probabilities of one segment of a FRACTIONAL SEG: the only one, or if there are
/// several, the one of that name.
[[nodiscard]] Result<ProbabilitiesOnVolume> readSegProbabilities(
    const QString& path, const QString& segment, const Volume& volume, const Progress& progress);

[[nodiscard]] Result<MaskOnVolume> readContourMask(
    const QString& path, const Volume& volume, const Progress& progress);
[[nodiscard]] Result<MaskOnVolume> readSurfaceMask(
    const QString& path, const Volume& volume, const Progress& progress);

/// As many labels as a session has.
constexpr std::size_t mostSegments = 255;

/// The error of a label map without a label. In a folder such a file is left out.
[[nodiscard]] tl::unexpected<Error> hasNoLabel(const QString& path);

/// The failure of a file in which a value cannot be a label.
/// @param value the first of them
[[nodiscard]] tl::unexpected<Error> holdsNoLabels(const QString& path, double value);

/// The failure of a file whose values cannot be labels and are as varied as those of an image. In a
/// folder such a file is left out, and so is one that fails as the next function says.
[[nodiscard]] tl::unexpected<Error> holdsImage(const QString& path);

/// The failure of a file with more labels than a session has segments.
[[nodiscard]] tl::unexpected<Error> holdsTooManyLabels(const QString& path);

/// A name for a segment without one: "liver.nii.gz" → "liver".
[[nodiscard]] QString maskNameOf(const QString& path);
/// The volume of voxels in mL.
[[nodiscard]] double millilitres(std::uint64_t voxels, const VolumeGeometry& geometry);

} // namespace core
