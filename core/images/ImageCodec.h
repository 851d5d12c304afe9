// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/images/ImagePage.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <span>

namespace core {

/// Decodes a page and passes its pixels, row by row, in the machine's byte order, to @p take.
/// libpng and libtiff run in a decoder process (core/fence), which only receives the bytes of that
/// page.
/// @return why it failed, in words; empty if it did not
[[nodiscard]] Clause decodeImageFenced(
    const ImagePage& page, const std::function<void(std::span<const std::uint8_t> pixels)>& take);

/// Whether the parameters of a decoder request describe a page.
[[nodiscard]] bool isImageRequest(std::span<const std::uint8_t> parameters);
/// The same in the calling process, without protection: what a decoder process does (its FencedWork
/// for pages).
[[nodiscard]] QString decodeImageHere(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> bytes, std::span<std::uint8_t> pixels);

} // namespace core
