// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/images/PixelGrid.h"

#include <QString>

#include <cstdint>
#include <span>

namespace core {

/// Decodes a TIFF of one page (tiffOfPage()) with libtiff; runs in decoder processes (core/fence).
/// @param pixels of grid.byteCount() bytes
/// @return what is wrong, in words; empty if nothing is
[[nodiscard]] QString decodeTiff(
    std::span<const std::uint8_t> bytes, const PixelGrid& grid, std::span<std::uint8_t> pixels);

/// Initialises what decodeTiff() would request from the system; to be called before a decoder
/// process gives up its rights.
void readyTiff();

} // namespace core
