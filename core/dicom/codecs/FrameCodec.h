// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"
#include "core/dicom/base/TransferSyntax.h"

#include <cstdint>
#include <functional>
#include <span>

namespace core {

/// What a decoder needs to know of a compressed frame besides its bytes.
struct CodedFrame {
    PixelCoding coding = PixelCoding::Unknown;
    QString transferSyntaxUid;
    PixelLayout layout;

    [[nodiscard]] std::size_t cellBytes() const;
};

/// Decodes one frame (encodedFrame()) and gives @p take the little-endian cells of its pixels, as
/// many as the layout says. Other people's code runs in a decoder (core/fence); RLE, our own, here.
/// @pre undecodableReason() has none @return why it failed, in words; empty if it did not
[[nodiscard]] QString decodeFenced(const CodedFrame& frame, std::span<const std::uint8_t> bytes,
    const std::function<void(std::span<const std::uint8_t> cells)>& take);

/// The same here and now, whatever comes of it: what a decoder does. The FencedWork of frames.
[[nodiscard]] QString decodeHere(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> bytes, std::span<std::uint8_t> cells);

/// Readies what decodeHere() would read from files: called before a decoder gives up that right.
void readyCodecs();

} // namespace core
