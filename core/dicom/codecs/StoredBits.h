// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <cstdint>
#include <span>

namespace core {

/// Takes stored values out of their cells (PS3.5 8.1.1): the BitsStored bits below and at HighBit,
/// sign-extended from the topmost of them if the values are signed. Whatever else a cell holds
/// (overlays, dirt) is masked. No decoder's own sign extension is trusted.
///
/// @param cells little-endian cells of layout.bitsAllocated (8 or 16) bits, one per pixel
/// @param stored 16-bit two's complement where layout.isSigned, else unsigned
void extractStoredBits(std::span<const std::uint8_t> cells, const PixelLayout& layout,
    std::span<std::uint16_t> stored);

} // namespace core
