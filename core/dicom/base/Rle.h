// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace core {

constexpr std::size_t rleHeaderSize = 64;

/// Whether a frame of @p frameSize bytes that begins with @p header can contain @p decodedSize
/// bytes: its segments follow each other inside it, and no run is longer than a run can be.
[[nodiscard]] bool isRleHeader(
    std::span<const std::uint8_t> header, std::size_t frameSize, std::uint64_t decodedSize);

/// Decodes one frame of DICOM RLE (PS3.5 annex G), one sample per pixel, into little-endian cells
/// of @p bytesPerCell bytes. This is our own code because DCMTK 3.6.7 reads beyond the end of
/// damaged frames.
///
/// @return false if the frame is damaged or does not fill the cells
[[nodiscard]] bool decodeRle(
    std::span<const std::uint8_t> frame, int bytesPerCell, std::span<std::uint8_t> cells);

} // namespace core
