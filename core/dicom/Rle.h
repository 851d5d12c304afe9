// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace core {

/// Decodes one frame of DICOM RLE (PS3.5 annex G), one sample per pixel, into little-endian cells
/// of
/// @p bytesPerCell bytes. Our own because DCMTK 3.6.7 reads beyond damaged frames.
///
/// @return false if the frame is damaged or does not fill the cells
[[nodiscard]] bool decodeRle(
    std::span<const std::uint8_t> frame, int bytesPerCell, std::span<std::uint8_t> cells);

} // namespace core
