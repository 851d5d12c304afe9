// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QList>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace core {

/// The fields of a MetaImage header (itk.org/Wiki/MetaIO/Documentation), not yet interpreted.
struct MetaImageHeader {
    QByteArray bytes; ///< as they lie in the file, up to where the data or the
                      ///< list begins
    std::map<QByteArray, QByteArray> fields; ///< by their names in the format
    QList<QByteArray> list; ///< the files listed after "ElementDataFile = LIST"

    [[nodiscard]] bool has(const char* name) const { return fields.contains(name); }
    /// Empty if the field is missing.
    [[nodiscard]] QByteArray field(const char* name) const;
    /// Numbers separated by blanks; none if there are none or something else.
    [[nodiscard]] std::optional<std::vector<double>> numbers(const char* name) const;
    /// True or False; @p otherwise if the field is missing.
    [[nodiscard]] bool flag(const char* name, bool otherwise) const;
};

/// Errors: FileUnreadable (not a MetaImage, a line that is not a field, a field twice, no
/// ElementDataFile).
/// @param path for the message
[[nodiscard]] Result<MetaImageHeader> parseMetaImageHeader(
    const QByteArray& bytes, const QString& path);

/// The same from a file, of which at most longestTextHeader is read. FileTruncated: it is empty.
[[nodiscard]] Result<MetaImageHeader> readMetaImageHeader(const QString& path);

} // namespace core
