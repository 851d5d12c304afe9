// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/StoredBits.h"

namespace core {

void extractStoredBits(
    std::span<const std::uint8_t> cells, const PixelLayout& layout, std::span<std::uint16_t> stored)
{
    const int shift = layout.highBit + 1 - layout.bitsStored;
    const std::uint32_t mask = (1u << layout.bitsStored) - 1u;
    const std::uint32_t sign = layout.isSigned ? 1u << (layout.bitsStored - 1) : 0u;
    const bool wide = layout.bitsAllocated == 16;
    for (std::size_t pixel = 0; pixel < stored.size(); ++pixel) {
        const std::uint32_t cell = wide
            ? std::uint32_t(cells[2 * pixel]) | std::uint32_t(cells[2 * pixel + 1]) << 8
            : std::uint32_t(cells[pixel]);
        const std::uint32_t value = (cell >> shift) & mask;
        // Flipping the sign bit and subtracting it extends it to the left.
        stored[pixel] = std::uint16_t((value ^ sign) - sign);
    }
}

} // namespace core
