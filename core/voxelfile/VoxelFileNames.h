// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QList>
#include <QString>
#include <QStringList>

namespace core {

/// Whether a header's word for its files announces a list of them: "LIST", with or without a
/// number.
[[nodiscard]] bool isFileList(const QByteArray& word);

/// The files that a header names for its voxels, from the header's folder on: one, those that are
/// listed, or a numbered series: "slice%03d.raw 1 40 1", perhaps with one number more (how many
/// axes a file holds). Of what printf knows, one whole number with a width and nothing else.
/// FileUnreadable: no names, or more than make up a volume.
/// @param list the names behind a word that isFileList()
[[nodiscard]] Result<QStringList> namedVoxelFiles(
    const QString& header, const QByteArray& word, const QList<QByteArray>& list);

} // namespace core
