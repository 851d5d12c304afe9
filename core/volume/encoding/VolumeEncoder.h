// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace core {

class Sha256;

/// Stored values, both ends included.
struct StoredRange {
    int lowest = 0;
    int highest = 0;
    bool operator==(const StoredRange&) const = default;
};

/// How the stored values of one slice become modality values: slope · stored + intercept, in double
/// (DICOM PS3.3 C.11.1).
struct SliceRescale {
    double slope = 1.0;
    double intercept = 0.0;
    bool isSigned = false; ///< stored values are two's complement
    /// Stored values of voxels outside the scanned region (PS3.3 C.7.5.1.1.2). They are kept, but
    /// do not count in the histogram and the window derived from it.
    std::optional<StoredRange> padding{};
    bool operator==(const SliceRescale&) const = default;
};

/// Turns stored 16-bit values into codes and describes them: sets encoding, minimum, maximum,
/// histogram, voxelsSha256, codesSha256 and, unless @p hasWindow, defaultWindow of @p
/// loaded.volume, and @p loaded.padding.
///
/// Exact if all slices share one rescale and their values fit 16 bits; otherwise on a common scale
/// with its error stated and an InexactValues problem. The checksum is always that of the exact
/// values. The volume's geometry must be set.
/// @param loaded codes: stored values in, codes out
/// @param slices one per slice k
void encodeStoredValues(LoadedVolume& loaded, std::span<const SliceRescale> slices, bool hasWindow);

/// The same for values of any kind: @p slice writes the exact modality values of one slice. It is
/// called from several threads, several times per slice. NaN counts as the minimum.
void encodeValues(LoadedVolume& loaded,
    const std::function<void(int k, std::span<double> values)>& slice, bool hasWindow);

/// Describes codes that were made from those of another volume and have its encoding: minimum,
/// maximum, histogram and voxelsSha256. The window is kept.
/// @param outside number of voxels, with code @p outsideCode, outside the scanned region, which do
/// not count in the histogram
void describeCodes(LoadedVolume& loaded, int outsideCode, std::uint64_t outside);

/// SHA-256 of the values of the codes, as in Volume::voxelsSha256, and of the codes, as in
/// Volume::codesSha256. Hex; one core takes a third of a second for 512 × 512 × 600 if the
/// processor has instructions for it.
[[nodiscard]] QByteArray sha256OfValues(const LoadedVolume& loaded);
[[nodiscard]] QByteArray sha256OfCodes(const LoadedVolume& loaded);

/// Adds the values of the codes to a checksum over several volumes.
void addValues(Sha256& hash, const LoadedVolume& loaded);

} // namespace core
