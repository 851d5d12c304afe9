// SPDX-License-Identifier: Apache-2.0
#include "core/metaimage/MetaImageHeader.h"

#include "core/voxelfile/GridFile.h"
#include "core/voxelfile/VoxelFileNames.h"

namespace core {

QByteArray MetaImageHeader::field(const char* name) const
{
    const auto found = fields.find(name);
    return found == fields.end() ? QByteArray() : found->second;
}

std::optional<std::vector<double>> MetaImageHeader::numbers(const char* name) const
{
    const QByteArray text = field(name).simplified();
    if (text.isEmpty())
        return std::nullopt;
    std::vector<double> values;
    for (const QByteArray& word : text.split(' ')) {
        bool isNumber = false;
        values.push_back(word.toDouble(&isNumber));
        if (!isNumber)
            return std::nullopt;
    }
    return values;
}

bool MetaImageHeader::flag(const char* name, bool otherwise) const
{
    const QByteArray value = field(name).toLower();
    return value.isEmpty() ? otherwise : value[0] == 't' || value[0] == '1';
}

Result<MetaImageHeader> parseMetaImageHeader(const QByteArray& bytes, const QString& path)
{
    const auto refused = [&](const Clause& reason) {
        return failure(ErrorCode::FileUnreadable, path, reason);
    };
    constexpr qsizetype longestName = 64;
    MetaImageHeader header;
    bool listing = false;
    for (qsizetype at = 0; at < bytes.size();) {
        qsizetype end = bytes.indexOf('\n', at);
        end = end < 0 ? bytes.size() : end;
        const QByteArray line = bytes.mid(at, end - at).trimmed();
        at = std::min(end + 1, bytes.size());
        if (listing) {
            if (!line.isEmpty())
                header.list.append(line);
            continue;
        }
        if (line.isEmpty())
            continue;
        const qsizetype equals = line.indexOf('=');
        if (equals <= 0 || equals > longestName)
            return refused(header.fields.empty()
                    ? Clause::saying("not a MetaImage file")
                    : Clause::saying("a line of its header is no field"));
        const QByteArray name = line.left(equals).trimmed();
        const QByteArray value = line.mid(equals + 1).trimmed();
        if (!header.fields.emplace(name, value).second)
            return refused(Clause::saying("its header has '%1' twice", QString::fromLatin1(name)));
        if (name != "ElementDataFile")
            continue;
        header.bytes = bytes.left(at);
        if (!isFileList(value))
            return header;
        listing = true;
    }
    if (!listing)
        return refused(header.has("NDims") || header.has("ObjectType")
                ? Clause::saying("its header does not say where the "
                                 "voxels are (ElementDataFile)")
                : Clause::saying("not a MetaImage file"));
    return header;
}

Result<MetaImageHeader> readMetaImageHeader(const QString& path)
{
    // The field that ends a header is looked for, then the line that it stands in.
    const auto isRead = [](const QByteArray& bytes, qsizetype before) {
        const qsizetype last = bytes.indexOf("ElementDataFile");
        if (last < 0)
            return before == 0 && bytes.contains('\0'); // no text at all
        const qsizetype end = bytes.indexOf('\n', last);
        return end >= 0 && !bytes.mid(last, end - last).contains("LIST");
    };
    const Result<QByteArray> bytes = readTextHeader(path, isRead);
    if (!bytes)
        return tl::unexpected(bytes.error());
    return parseMetaImageHeader(*bytes, path);
}

} // namespace core
