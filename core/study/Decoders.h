// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstdint>
#include <span>

namespace core {

/// Readies what decodeForAll() would read from files: called before a decoder gives up that right.
void readyDecoders();

/// What a decoder of this program does (core/fence): frames of DICOM, pages of PNG and TIFF. A
/// FencedWork.
[[nodiscard]] QString decodeForAll(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> bytes, std::span<std::uint8_t> output);

} // namespace core
