// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/images/PixelGrid.h"

#include <QString>

#include <cstdint>
#include <span>

namespace core {

/// Decodes a grey-scale PNG with libpng; runs in decoder processes (core/fence).
/// @param grid the layout according to its header
/// @param pixels of grid.byteCount() bytes
/// @return what is wrong, in words; empty if nothing is
[[nodiscard]] QString decodePng(
    std::span<const std::uint8_t> bytes, const PixelGrid& grid, std::span<std::uint8_t> pixels);

} // namespace core
