// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/images/ImagePage.h"

#include <QByteArray>

class QFile;

namespace core {

/// Whether a file is a TIFF or BigTIFF of either byte order, by its first bytes.
[[nodiscard]] bool isTiff(const QByteArray& begin);

/// Reads the directories of a TIFF one after the other. Their number and what they refer to is
/// limited, and nothing is decoded. Thumbnails are left out. Errors: those of readImagePages().
/// @param file open
[[nodiscard]] Result<std::vector<ImagePage>> readTiffPages(QFile& file);

/// A TIFF with only this page, and with a new directory that contains only what was checked. This
/// is all that a decoder receives. Empty if the file no longer contains the page.
[[nodiscard]] QByteArray tiffOfPage(const ImagePage& page);

} // namespace core
