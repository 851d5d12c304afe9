// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QList>
#include <QString>
#include <QStringList>

namespace core {

/// Whether the header's value for its files announces a list of them: "LIST", with or without a
/// number.
[[nodiscard]] bool isFileList(const QByteArray& word);

/// The files with the voxels of a header, relative to the header's folder: a single one, a list, or
/// a numbered series: "slice%03d.raw 1 40 1", optionally with a further number (the number of axes
/// in each file). Of printf's formats, one integer with a width is supported and nothing else.
/// FileUnreadable: no names, or more than a volume can have.
/// @param list the names after a value for which isFileList() holds
[[nodiscard]] Result<QStringList> namedVoxelFiles(
    const QString& header, const QByteArray& word, const QList<QByteArray>& list);

} // namespace core
