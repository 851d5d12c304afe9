// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/Rle.h"

#include <algorithm>

namespace core {

namespace {

std::uint32_t word(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return std::uint32_t(bytes[at]) | std::uint32_t(bytes[at + 1]) << 8
        | std::uint32_t(bytes[at + 2]) << 16 | std::uint32_t(bytes[at + 3]) << 24;
}

/// Unpacks one segment into every @p stride-th byte from @p first on.
bool unpackSegment(std::span<const std::uint8_t> packed, std::span<std::uint8_t> cells,
    std::size_t first, std::size_t stride)
{
    std::size_t in = 0;
    std::size_t out = first;
    while (out < cells.size()) {
        if (in >= packed.size())
            return false;
        const int control = std::int8_t(packed[in++]);
        if (control == -128)
            continue;
        const bool isRun = control < 0;
        const std::size_t count = std::size_t(isRun ? 1 - control : 1 + control);
        const std::size_t bytes = isRun ? 1 : count;
        if (bytes > packed.size() - in)
            return false;
        // The last run may go beyond the frame; what does not fit is padding.
        for (std::size_t step = 0; step < count && out < cells.size(); ++step, out += stride)
            cells[out] = packed[in + (isRun ? 0 : step)];
        in += bytes;
    }
    return true;
}

} // namespace

bool isRleHeader(
    std::span<const std::uint8_t> header, std::size_t frameSize, std::uint64_t decodedSize)
{
    constexpr std::uint32_t maximumSegments = 15;
    constexpr std::uint64_t maximumRatio = 64; // a run of 128 in two bytes
    if (header.size() < rleHeaderSize || frameSize < rleHeaderSize)
        return false;
    const std::uint32_t segments = word(header, 0);
    if (segments < 1 || segments > maximumSegments)
        return false;
    std::size_t before = rleHeaderSize;
    for (std::size_t segment = 0; segment < segments; ++segment) {
        const std::size_t begin = word(header, 4 + 4 * segment);
        if (begin < before || begin > frameSize)
            return false;
        before = begin;
    }
    return decodedSize / maximumRatio <= frameSize - rleHeaderSize;
}

bool decodeRle(std::span<const std::uint8_t> frame, int bytesPerCell, std::span<std::uint8_t> cells)
{
    const auto segments = std::size_t(bytesPerCell);
    if (!isRleHeader(frame, frame.size(), cells.size()) || word(frame, 0) != segments)
        return false;
    for (std::size_t segment = 0; segment < segments; ++segment) {
        const std::size_t begin = word(frame, 4 + 4 * segment);
        const std::size_t end =
            segment + 1 < segments ? word(frame, 8 + 4 * segment) : frame.size();
        // The most significant byte comes first (PS3.5 G.2).
        if (!unpackSegment(
                frame.subspan(begin, end - begin), cells, segments - 1 - segment, segments))
            return false;
    }
    return true;
}

} // namespace core
