// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/images/ImagePage.h"

#include <QByteArray>

class QFile;

namespace core {

/// By a file's first bytes.
[[nodiscard]] bool isPng(const QByteArray& begin);

/// The chunks of a PNG before its data, walked by their lengths; nothing is unpacked. Errors as of
/// readImagePages(). @param file open
[[nodiscard]] Result<ImagePage> readPngHeader(QFile& file);

} // namespace core
