// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/images/ImagePage.h"

#include <QByteArray>

class QFile;

namespace core {

/// By a file's first bytes: TIFF or BigTIFF, of either byte order.
[[nodiscard]] bool isTiff(const QByteArray& begin);

/// The directories of a TIFF, walked one after the other: bounded in number and in what they refer
/// to, nothing decoded. Small pictures for a list (thumbnails) are left out. Errors as of
/// readImagePages(). @param file open
[[nodiscard]] Result<std::vector<ImagePage>> readTiffPages(QFile& file);

/// A TIFF of this page alone, with a directory of our own that names what was checked and nothing
/// else: all that a decoder gets to see. Empty if the file does not hold it any more.
[[nodiscard]] QByteArray tiffOfPage(const ImagePage& page);

} // namespace core
