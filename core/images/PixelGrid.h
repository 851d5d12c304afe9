// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace core {

/// The layout of the bytes of a decoded picture.
struct PixelGrid {
    int columns = 0;
    int rows = 0;
    std::size_t pixelBytes = 1;

    [[nodiscard]] std::size_t rowBytes() const { return std::size_t(columns) * pixelBytes; }
    [[nodiscard]] std::size_t byteCount() const { return rowBytes() * std::size_t(rows); }
};

} // namespace core
