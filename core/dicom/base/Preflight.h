// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/base/DicomElement.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The image that a header promises, read with no trust in it.
struct PromisedImage {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t samplesPerPixel = 1;
    std::uint32_t bitsAllocated = 0;
    std::uint64_t frames = 1;

    /// Bytes of one frame once decoded. Cannot overflow.
    [[nodiscard]] std::uint64_t frameBytes() const;
    /// Bytes of all frames once decoded; nothing where they cannot be counted in 64 bits.
    [[nodiscard]] std::optional<std::uint64_t> bytes() const;
};

/// Where bytes lie.
struct ByteRange {
    std::size_t at = 0;
    std::size_t size = 0;
};

/// What preflight() found. Places are relative to the beginning of the data set.
struct PreflightFacts {
    PromisedImage image;
    bool hasPixels = false;
    bool pixelsEncapsulated = false;
    bool pixelsAreWords = true; ///< VR OW, which matters for big endian
    int floatBits = 0; ///< 32 or 64 where pixels are floating-point numbers
    bool pixelsCut = false; ///< the bytes end before the pixel data do
    ByteRange pixels; ///< of pixel data that are not encapsulated: as long as they claim to be
    std::vector<ByteRange>
        fragments; ///< of encapsulated ones, without the offset table (PS3.5 A.4)
    /// The offset table is empty, or ascends and names beginnings of fragments. Nothing reads it.
    bool offsetTableSound = true;
};

/// Walks over a data set before any other parser touches it, up to its pixel data; what some
/// writers leave behind them is ignored. Reads headers of elements, never their values but for the
/// size of the image; time grows with the number of elements, memory with that of the fragments.
///
/// DCMTK 3.6.7 parses sequences recursively without limit and believes lengths. Refused are
/// nesting deeper than 64, lengths beyond the end, sequences that do not end, more elements than
/// DCMTK takes in reasonable time, and images that no memory holds. Cut pixel data are not: the
/// slice has its place.
///
/// @return FileTruncated where more bytes would have helped, FileUnreadable; both name @p path
[[nodiscard]] Result<PreflightFacts> preflight(
    DicomBytes dataSet, const DataSetForm& form, const QString& path);

} // namespace core
