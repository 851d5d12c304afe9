// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QHash>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <vector>

namespace app {

/// One study of a batch.
struct BatchStudy {
    QString path; ///< absolute
    QString name; ///< of its folder among the results; unique in the list
    QString session; ///< name of the session's file in that folder
    QString series; ///< key of the series, as for --series; empty: the study has only one series
    QString repair;
    QString spacing;
    /// Values for placeholders of the recipe, by name: texts, numbers, true and false.
    QJsonObject variables{};
    /// The cells of a table as they stand there, by name of the variable. A variable that is a
    /// number has lost how it was written ("1.50").
    QHash<QString, QString> cells{};
};

/// Reads the studies of a batch: from a list (CSV, TSV or JSON), or from a folder. Every entry of a
/// folder is a study, except files whose names mark them as accompanying files (scan.json, a.raw,
/// readme.txt), unless they are marked as DICOM files (PS3.10 section 7.1).
///
/// The first line of a table has the names of the columns; JSON is a list of objects with these
/// names as keys, or of paths. "study" is required; "name", "session", "series", "repair" and
/// "spacing" are optional; any other column is a variable of the recipe. A cell of a table that
/// reads as a number is one, unless it has a zero in front or more digits than a number keeps
/// ("0012" is a name). Paths are relative to the list. Without a name a study is named after its
/// file, without extension. Errors: FileNotFound, FileUnreadable (with the line or entry),
/// FolderEmpty.
/// @param results the folder for the batch's results: an entry that is this folder, or contains it,
/// is not a study
/// @param leftOut receives the names of the files in a folder that were left out as accompanying
///     files
[[nodiscard]] core::Result<std::vector<BatchStudy>> readStudyList(
    const QString& path, const QString& results = QString(), QStringList* leftOut = nullptr);

/// Splits a table into rows of cells, with quotes as in RFC 4180. @p between separates cells. Used
/// for lists of studies and for statistics. Errors: InvalidField with the line, counted from 1.
[[nodiscard]] core::Result<std::vector<QStringList>> readTable(const QString& text, QChar between);

} // namespace app
