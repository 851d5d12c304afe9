// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/images/ImagePage.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <span>

namespace core {

/// Decodes a page and gives @p take its pixels, row after row, in the machine's byte order. libpng
/// and libtiff run in a decoder (core/fence), which sees the bytes of that page alone.
/// @return why it failed, in words; empty if it did not
[[nodiscard]] QString decodeImageFenced(
    const ImagePage& page, const std::function<void(std::span<const std::uint8_t> pixels)>& take);

/// Whether a decoder's parameters are those of a page.
[[nodiscard]] bool isImageRequest(std::span<const std::uint8_t> parameters);
/// The same here and now, whatever comes of it: what a decoder does. The FencedWork of pages.
[[nodiscard]] QString decodeImageHere(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> bytes, std::span<std::uint8_t> pixels);

} // namespace core
