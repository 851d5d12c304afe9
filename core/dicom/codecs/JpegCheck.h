// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <cstdint>
#include <span>

namespace core {

/// Checks a JPEG or JPEG-LS stream before DCMTK reads it: its frame header must have the size of
/// the DICOM header and one component, and no marker may make a decoder loop (the TEM marker, FF01,
/// hangs DCMTK 3.6.7).
///
/// @return what is wrong, in words; empty if nothing is
[[nodiscard]] QString checkJpeg(std::span<const std::uint8_t> stream, const PixelLayout& layout);

} // namespace core
