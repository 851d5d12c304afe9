// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <vector>

namespace core {

class DicomFile;
struct SegFile;

/// The pixel data of a DICOM SEG as SegFile::bits holds them. Compressed frames of 8 or 16 bits are
/// decoded, in parallel; codecs of others run in processes without rights (core/fence).
/// @param file opened with its pixels @param path of it
/// @param seg whose rows, columns, frames and bitsPerPixel are known
/// Any thread outside a parallelFor(). Errors: FileTruncated (less than the frames need),
/// UnsupportedFormat (compressed with loss, in an unknown way, or with one bit a pixel),
/// FileUnreadable (a frame cannot be decoded), OutOfMemory.
[[nodiscard]] Result<std::vector<std::uint8_t>> segPixels(
    const DicomFile& file, const QString& path, const SegFile& seg);

} // namespace core
