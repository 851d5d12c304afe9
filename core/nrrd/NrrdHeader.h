// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QList>
#include <QString>

#include <map>

namespace core {

/// The fields of an NRRD header (teem.sourceforge.net/nrrd/format.html), not yet interpreted.
struct NrrdHeader {
    QByteArray bytes; ///< as in the file, with the blank line that ends an attached header
    /// By their names in lower case without blanks: "space directions" is "spacedirections".
    std::map<QByteArray, QByteArray> fields;
    std::map<QByteArray, QByteArray> keyValues; ///< key:=value, escapes resolved
    QList<QByteArray> list; ///< the files listed after "data file: LIST"

    [[nodiscard]] QByteArray field(const char* name) const;
    [[nodiscard]] bool isDetached() const { return fields.contains("datafile"); }
};

/// Errors: FileUnreadable (not an NRRD, an invalid line, a field twice), FileTruncated (empty).
/// @param path for the message
[[nodiscard]] Result<NrrdHeader> parseNrrdHeader(const QByteArray& bytes, const QString& path);

/// The same from a file, of which at most longestTextHeader is read.
[[nodiscard]] Result<NrrdHeader> readNrrdHeader(const QString& path);

} // namespace core
