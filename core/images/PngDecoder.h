// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/images/PixelGrid.h"

#include <QString>

#include <cstdint>
#include <span>

namespace core {

/// Decodes a PNG in grey by libpng; runs in decoders (core/fence). @param grid what its header was
/// found to say @param pixels of grid.byteCount() @return what is wrong; empty if nothing is
[[nodiscard]] QString decodePng(
    std::span<const std::uint8_t> bytes, const PixelGrid& grid, std::span<std::uint8_t> pixels);

} // namespace core
