// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/base/ImageHeader.h"

#include <vector>

namespace core {

/// Reads what Burin needs to know about one DICOM file, up to its pixel data: one header per image
/// of it (framesOf()), never none. Any thread.
///
/// UnsupportedFormat for files that are not DICOM, FileTruncated, FileUnreadable: each with the
/// file and the reason.
[[nodiscard]] Result<std::vector<ImageHeader>> readImageHeaders(const QString& path);

/// The first image's.
[[nodiscard]] Result<ImageHeader> readImageHeader(const QString& path);

} // namespace core
