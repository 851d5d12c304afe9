// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/base/ImageHeader.h"

#include <vector>

namespace core {

/// Reads the headers of one DICOM file, up to its pixel data: one per image in it (framesOf()), at
/// least one. Any thread.
///
/// Errors: UnsupportedFormat for files that are not DICOM, FileTruncated, FileUnreadable; each with
/// the file and the reason.
[[nodiscard]] Result<std::vector<ImageHeader>> readImageHeaders(const QString& path);

/// The header of the first image.
[[nodiscard]] Result<ImageHeader> readImageHeader(const QString& path);

} // namespace core
