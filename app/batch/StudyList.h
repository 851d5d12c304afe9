// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QJsonObject>
#include <QString>

#include <vector>

namespace app {

/// One study of a batch.
struct BatchStudy {
    QString path; ///< absolute
    QString name; ///< of its folder among the results; no other study has it
    QString session; ///< the session's file, without a folder
    QString series; ///< with its repair, as --series has them; empty: the study has only one
    QString repair;
    QString spacing;
    QJsonObject variables{}; ///< by name: texts, numbers, true and false
};

/// Reads the studies of a batch: a list, as CSV, TSV or JSON, or a folder, each entry of which is a
/// study.
///
/// A table has a first line with the names of its columns, JSON a list of objects with these keys
/// (or of paths): "study" is needed; "name", "session", "series", "repair" and "spacing" are
/// optional; all others are variables of the recipe. Paths are relative to the list. A name that is
/// not given is the file's, without its ending.
/// Errors: FileNotFound, FileUnreadable (with the line or entry), FolderEmpty.
[[nodiscard]] core::Result<std::vector<BatchStudy>> readStudyList(const QString& path);

/// A line of a table: cells with quotes as in RFC 4180. For lists, and for statistics.
/// Errors: InvalidField with the line, counted from 1.
[[nodiscard]] core::Result<std::vector<QStringList>> readTable(const QString& text, QChar between);

} // namespace app
