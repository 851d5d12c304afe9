// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QList>
#include <QString>

#include <map>

namespace core {

/// The words of an NRRD header (teem.sourceforge.net/nrrd/format.html), not yet what they mean.
struct NrrdHeader {
    QByteArray bytes; ///< as they lie in the file, with the blank line that ends an attached one
    /// By their names in small letters, without blanks: "space directions" is "spacedirections".
    std::map<QByteArray, QByteArray> fields;
    std::map<QByteArray, QByteArray> keyValues; ///< key:=value, escapes resolved
    QList<QByteArray> list; ///< the files behind "data file: LIST"

    [[nodiscard]] QByteArray field(const char* name) const;
    [[nodiscard]] bool isDetached() const { return fields.contains("datafile"); }
};

/// FileUnreadable (no NRRD, a line that is none, a field twice), FileTruncated (nothing in it).
/// @param path for the sentence
[[nodiscard]] Result<NrrdHeader> parseNrrdHeader(const QByteArray& bytes, const QString& path);

/// The same from a file; reads no further than longestTextHeader.
[[nodiscard]] Result<NrrdHeader> readNrrdHeader(const QString& path);

} // namespace core
