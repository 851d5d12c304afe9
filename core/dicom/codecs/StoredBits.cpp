// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/codecs/StoredBits.h"

#include <bit>
#include <cstring>

namespace core {

namespace {

template <typename Cell>
bool anyCutOff(std::span<const std::uint8_t> cells, std::uint32_t above, std::uint32_t sign)
{
    std::uint32_t cutOff = 0;
    for (std::size_t at = 0; at + sizeof(Cell) <= cells.size(); at += sizeof(Cell)) {
        Cell cell = 0;
        std::memcpy(&cell, cells.data() + at, sizeof(cell));
        const std::uint32_t bits = cell & above;
        const std::uint32_t extended = (cell & sign) != 0 ? above : 0u;
        cutOff |= bits == extended ? 0u : bits;
    }
    return cutOff != 0;
}

} // namespace

bool areCutOff(std::span<const std::uint8_t> cells, const PixelLayout& layout)
{
    const std::uint32_t all = (1u << layout.bitsAllocated) - 1u;
    const std::uint32_t above = (all & ~((2u << layout.highBit) - 1u)) & ~layout.overlayBits;
    const std::uint32_t sign = layout.isSigned ? 1u << layout.highBit : 0u;
    if (above == 0)
        return false;
    return layout.bitsAllocated == 8 ? anyCutOff<std::uint8_t>(cells, above, sign)
                                     : anyCutOff<std::uint16_t>(cells, above, sign);
}

void extractStoredBits(
    std::span<const std::uint8_t> cells, const PixelLayout& layout, std::span<std::uint16_t> stored)
{
    const int shift = layout.highBit + 1 - layout.bitsStored;
    const std::uint32_t mask = (1u << layout.bitsStored) - 1u;
    const std::uint32_t sign = layout.isSigned ? 1u << (layout.bitsStored - 1) : 0u;
    const auto valueOf = [=](std::uint32_t cell) {
        const std::uint32_t value = (cell >> shift) & mask;
        // Flipping the sign bit and subtracting it extends it to the left.
        return std::uint16_t((value ^ sign) - sign);
    };
    if (layout.bitsAllocated == 8) {
        for (std::size_t pixel = 0; pixel < stored.size(); ++pixel)
            stored[pixel] = valueOf(cells[pixel]);
        return;
    }
    static_assert(std::endian::native == std::endian::little);
    std::memcpy(stored.data(), cells.data(), stored.size_bytes());
    if (layout.bitsStored == 16)
        return;
    for (std::uint16_t& pixel : stored)
        pixel = valueOf(pixel);
}

void extractStoredNumbers(
    std::span<const std::uint8_t> cells, const PixelLayout& layout, std::span<double> numbers)
{
    static_assert(std::endian::native == std::endian::little);
    const int shift = layout.highBit + 1 - layout.bitsStored;
    const std::uint32_t mask = ~0u >> (32 - layout.bitsStored);
    const std::uint32_t sign = layout.isSigned ? 1u << (layout.bitsStored - 1) : 0u;
    for (std::size_t pixel = 0; pixel < numbers.size(); ++pixel) {
        std::uint32_t cell = 0;
        std::memcpy(&cell, cells.data() + pixel * sizeof(cell), sizeof(cell));
        const std::uint32_t value = (((cell >> shift) & mask) ^ sign) - sign;
        numbers[pixel] = layout.isSigned ? double(std::int32_t(value)) : double(value);
    }
}

} // namespace core
