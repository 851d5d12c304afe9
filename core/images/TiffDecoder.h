// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/images/PixelGrid.h"

#include <QString>

#include <cstdint>
#include <span>

namespace core {

/// Decodes a TIFF of one page (tiffOfPage()) by libtiff; runs in decoders (core/fence).
/// @param pixels of grid.byteCount() @return what is wrong; empty if nothing is
[[nodiscard]] QString decodeTiff(
    std::span<const std::uint8_t> bytes, const PixelGrid& grid, std::span<std::uint8_t> pixels);

/// Readies what decodeTiff() would ask the system for: called before a decoder gives up that right.
void readyTiff();

} // namespace core
