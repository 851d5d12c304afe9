// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <cstdint>
#include <span>

namespace core {

/// Looks at a JPEG or JPEG-LS stream before DCMTK does: its frame header must name the size the
/// DICOM header names and one component, and its markers must be such that no decoder loops (the
/// TEM marker, FF01, hangs DCMTK 3.6.7).
///
/// @return what is wrong, in words; empty if nothing is
[[nodiscard]] QString checkJpeg(std::span<const std::uint8_t> stream, const PixelLayout& layout);

} // namespace core
