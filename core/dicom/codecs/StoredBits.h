// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <cstdint>
#include <span>

namespace core {

/// Extracts stored values from their cells (PS3.5 8.1.1): the BitsStored bits at and below HighBit,
/// sign-extended from the topmost of them if the values are signed. All other bits of a cell
/// (overlays, garbage) are masked. The sign extension of decoders is not relied on.
///
/// @param cells little-endian cells of layout.bitsAllocated (8 or 16) bits, one per pixel
/// @param stored 16-bit two's complement if layout.isSigned, else unsigned
void extractStoredBits(std::span<const std::uint8_t> cells, const PixelLayout& layout,
    std::span<std::uint16_t> stored);

/// Whether cells of 8 or 16 bits hold values that do not fit BitsStored: bits above HighBit that
/// are neither overlays nor an extension of the sign. extractStoredBits() cuts them off.
[[nodiscard]] bool areCutOff(std::span<const std::uint8_t> cells, const PixelLayout& layout);

/// The same as extractStoredBits() for cells of 32 bits.
void extractStoredNumbers(
    std::span<const std::uint8_t> cells, const PixelLayout& layout, std::span<double> numbers);

} // namespace core
