// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/images/ImagePage.h"

#include <QByteArray>

class QFile;

namespace core {

/// Whether a file is a PNG, by its first bytes.
[[nodiscard]] bool isPng(const QByteArray& begin);

/// Reads the chunks of a PNG before its data, by their lengths, without unpacking anything. Errors:
/// those of readImagePages(). @param file open
[[nodiscard]] Result<ImagePage> readPngHeader(QFile& file);

} // namespace core
