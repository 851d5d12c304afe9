// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstdint>
#include <span>

namespace core {

/// Initialises what decodeForAll() would read from files; to be called before a decoder process
/// gives up that right.
void readyDecoders();

/// The work of this program's decoder processes (core/fence): frames of DICOM, pages of PNG and
/// TIFF. A FencedWork.
[[nodiscard]] QString decodeForAll(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> bytes, std::span<std::uint8_t> output);

} // namespace core
