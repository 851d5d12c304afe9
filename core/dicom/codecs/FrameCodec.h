// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/dicom/base/ImageHeader.h"
#include "core/dicom/base/TransferSyntax.h"

#include <cstdint>
#include <functional>
#include <span>

namespace core {

/// What a decoder must know of a compressed frame besides its bytes.
struct CodedFrame {
    PixelCoding coding = PixelCoding::Unknown;
    QString transferSyntaxUid;
    PixelLayout layout;

    [[nodiscard]] std::size_t cellBytes() const;
};

/// Decodes one frame (encodedFrame()) and passes the little-endian cells of its pixels to @p take,
/// as many as the layout says. Third-party code runs in a decoder process (core/fence); our own RLE
/// decoder runs here.
/// @pre undecodableReason() has none
/// @return why it failed, in words; empty if it did not
[[nodiscard]] Clause decodeFenced(const CodedFrame& frame, std::span<const std::uint8_t> bytes,
    const std::function<void(std::span<const std::uint8_t> cells)>& take);

/// The same in the calling process, without protection: what a decoder process does (its FencedWork
/// for frames).
[[nodiscard]] QString decodeHere(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> bytes, std::span<std::uint8_t> cells);

/// Initialises what decodeHere() would read from files; to be called before a decoder process gives
/// up the right to open files.
void readyCodecs();

} // namespace core
