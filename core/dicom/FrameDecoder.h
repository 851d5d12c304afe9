// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/ImageHeader.h"

#include <cstdint>
#include <span>

namespace core {

/// Why Burin cannot decode this image, in words; empty if it can (as far as the header tells).
[[nodiscard]] QString undecodableReason(const ImageHeader& header);

/// Decodes the one frame of a file into stored values (extractStoredBits), columns first.
///
/// The file is read again; no parser but our own sees more of it than the pixel data. Any thread.
/// Errors name the file: FileTruncated, UnsupportedFormat, FileUnreadable (damaged pixel data).
[[nodiscard]] Result<void> decodeFrame(const ImageHeader& header, std::span<std::uint16_t> stored);

} // namespace core
