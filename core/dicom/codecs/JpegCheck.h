// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <cstdint>
#include <span>

namespace core {

/// What checkJpeg() found out about a stream.
struct JpegFacts {
    QString wrong; ///< in words; empty: nothing
    int precision = 0; ///< bits per sample, if nothing is wrong
};

/// Checks a JPEG or JPEG-LS stream before DCMTK reads it: its frame header must have the size of
/// the DICOM header and one component, and no marker may make a decoder loop (the TEM marker, FF01,
/// hangs DCMTK 3.6.7).
[[nodiscard]] JpegFacts checkJpeg(std::span<const std::uint8_t> stream, const PixelLayout& layout);

} // namespace core
