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

/// The words of a MetaImage header (itk.org/Wiki/MetaIO/Documentation), not yet
/// what they mean.
struct MetaImageHeader {
    QByteArray bytes; ///< as they lie in the file, up to where the data or the
                      ///< list begins
    std::map<QByteArray, QByteArray> fields; ///< by names as the format writes them
    QList<QByteArray> list; ///< the files behind "ElementDataFile = LIST"

    [[nodiscard]] bool has(const char* name) const { return fields.contains(name); }
    /// Empty where it is not there.
    [[nodiscard]] QByteArray field(const char* name) const;
    /// Numbers apart by blanks; none if there are none, or other things.
    [[nodiscard]] std::optional<std::vector<double>> numbers(const char* name) const;
    /// True or False; @p otherwise where it is not there.
    [[nodiscard]] bool flag(const char* name, bool otherwise) const;
};

/// FileUnreadable (no MetaImage, a line that is no field, a field twice, no
/// ElementDataFile).
/// @param path for the sentence
[[nodiscard]] Result<MetaImageHeader> parseMetaImageHeader(
    const QByteArray& bytes, const QString& path);

/// The same from a file; reads no further than longestTextHeader.
/// FileTruncated: nothing in it.
[[nodiscard]] Result<MetaImageHeader> readMetaImageHeader(const QString& path);

} // namespace core
