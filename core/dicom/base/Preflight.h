// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/base/DicomElement.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The image that a header promises, none of which is trusted.
struct PromisedImage {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t samplesPerPixel = 1;
    std::uint32_t bitsAllocated = 0;
    std::uint64_t frames = 1;

    /// Bytes of one frame once decoded. Cannot overflow.
    [[nodiscard]] std::uint64_t frameBytes() const;
    /// Bytes of all frames once decoded; none if the number exceeds 64 bits.
    [[nodiscard]] std::optional<std::uint64_t> bytes() const;
};

/// A range of bytes.
struct ByteRange {
    std::size_t at = 0;
    std::size_t size = 0;
};

/// What preflight() found. Positions are relative to the beginning of the data set.
struct PreflightFacts {
    PromisedImage image;
    bool hasPixels = false;
    bool pixelsEncapsulated = false;
    bool pixelsAreWords = true; ///< VR OW, which matters for big endian
    int floatBits = 0; ///< 32 or 64 if pixels are floating-point numbers
    bool pixelsCut = false; ///< the bytes end before the pixel data do
    ByteRange pixels; ///< of unencapsulated pixel data; its size is the one that they claim
    std::vector<ByteRange>
        fragments; ///< of encapsulated ones, without the offset table (PS3.5 A.4)
    /// The offset table is empty, or it ascends and points to beginnings of fragments. Nothing uses
    /// it.
    bool offsetTableSound = true;
};

/// Walks through a data set before any other parser reads it, up to its pixel data; what some
/// writers put after them is ignored. It reads headers of elements, and no values except the size
/// of the image. Time grows with the number of elements, memory with that of fragments.
///
/// DCMTK 3.6.7 parses sequences recursively without limit and trusts lengths. Therefore these are
/// refused: nesting deeper than 64, lengths beyond the end, sequences without an end, more elements
/// than DCMTK can process in reasonable time, and images that exceed any memory. Pixel data that
/// are cut off are accepted, since the slice still has its position.
///
/// @return FileTruncated if more bytes would have helped, FileUnreadable; both name @p path
[[nodiscard]] Result<PreflightFacts> preflight(
    DicomBytes dataSet, const DataSetForm& form, const QString& path);

} // namespace core
