// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <cstdint>
#include <span>

namespace core {

/// Decodes a JPEG 2000 or HTJ2K codestream (also inside a JP2 file) by OpenJPEG into little-endian
/// cells. The codestream's size is compared with the header before anything is allocated for it.
///
/// @return why it failed, in words; empty if it did not
[[nodiscard]] QString decodeJpeg2000(std::span<const std::uint8_t> codestream,
    const PixelLayout& layout, std::span<std::uint8_t> cells);

} // namespace core
