// SPDX-License-Identifier: Apache-2.0
#include "core/nrrd/NrrdHeader.h"

#include "core/voxelfile/GridFile.h"
#include "core/voxelfile/VoxelFileNames.h"

#include <algorithm>

namespace core {

namespace {

constexpr qsizetype magicSize = 8;

bool isMagic(const QByteArray& line)
{
    return line.size() == magicSize && line.startsWith("NRRD000") && line[7] >= '1'
        && line[7] <= '6';
}

QByteArray plainName(const QByteArray& name)
{
    return name.toLower().replace(' ', "").replace('\t', "");
}

/// "\n" and "\\" as values write them.
QByteArray unescaped(const QByteArray& value)
{
    QByteArray plain;
    for (qsizetype at = 0; at < value.size(); ++at) {
        const char next = at + 1 < value.size() ? value[at + 1] : '\0';
        if (value[at] == '\\' && (next == 'n' || next == '\\')) {
            plain += next == 'n' ? '\n' : '\\';
            ++at;
        } else {
            plain += value[at];
        }
    }
    return plain;
}

/// One past the blank line that ends a header, from @p from on; -1: there is none yet.
qsizetype endOfHeader(const QByteArray& bytes, qsizetype from)
{
    for (qsizetype at = bytes.indexOf('\n', from); at >= 0; at = bytes.indexOf('\n', at + 1)) {
        const qsizetype next = at + 1;
        if (next < bytes.size() && bytes[next] == '\n')
            return next + 1;
        if (next + 1 < bytes.size() && bytes[next] == '\r' && bytes[next + 1] == '\n')
            return next + 2;
    }
    return -1;
}

} // namespace

QByteArray NrrdHeader::field(const char* name) const
{
    const auto found = fields.find(QByteArray::fromRawData(name, qsizetype(qstrlen(name))));
    return found == fields.end() ? QByteArray() : found->second;
}

Result<NrrdHeader> parseNrrdHeader(const QByteArray& bytes, const QString& path)
{
    const auto refused = [&](const Clause& reason) {
        return failure(ErrorCode::FileUnreadable, path, reason);
    };
    NrrdHeader header{.bytes = bytes};
    bool first = true;
    bool listing = false;
    for (qsizetype at = 0; at < bytes.size();) {
        qsizetype end = bytes.indexOf('\n', at);
        end = end < 0 ? bytes.size() : end;
        QByteArray line = bytes.mid(at, end - at);
        at = end + 1;
        if (line.endsWith('\r'))
            line.chop(1);
        if (first) {
            if (!isMagic(line.trimmed()))
                return refused(Clause::saying("not an NRRD file"));
            first = false;
            continue;
        }
        if (line.trimmed().isEmpty())
            break;
        if (listing) {
            header.list.append(line.trimmed());
            continue;
        }
        if (line.startsWith('#'))
            continue;
        const qsizetype colon = line.indexOf(':');
        if (colon <= 0)
            return refused(Clause::saying("a line of its header is no field"));
        if (line.mid(colon + 1, 1) == "=") {
            header.keyValues[unescaped(line.left(colon))] = unescaped(line.mid(colon + 2));
            continue;
        }
        const QByteArray name = plainName(line.left(colon));
        const QByteArray value = line.mid(colon + 1).trimmed();
        if (!header.fields.emplace(name, value).second) {
            return refused(
                Clause::saying("its header has '%1' twice", QString::fromLatin1(name.left(40))));
        }
        listing = name == "datafile" && isFileList(value);
    }
    if (first)
        return refused(Clause::saying("not an NRRD file"));
    return header;
}

Result<NrrdHeader> readNrrdHeader(const QString& path)
{
    const auto mayBeNrrd = [](const QByteArray& bytes) {
        return bytes.startsWith(QByteArrayView("NRRD000", std::min<qsizetype>(7, bytes.size())));
    };
    qsizetype end = -1;
    Result<QByteArray> bytes = readTextHeader(path, [&](const QByteArray& read, qsizetype before) {
        end = endOfHeader(read, std::max<qsizetype>(0, before - 3));
        return end >= 0 || !mayBeNrrd(read);
    });
    if (!bytes)
        return tl::unexpected(bytes.error());
    if (!mayBeNrrd(*bytes))
        return failure(ErrorCode::FileUnreadable, path, Clause::saying("not an NRRD file"));
    if (end >= 0)
        bytes->truncate(end);
    Result<NrrdHeader> header = parseNrrdHeader(*bytes, path);
    if (header && end < 0 && !header->isDetached())
        return failure(ErrorCode::FileTruncated, path, Clause::saying("its header has no end"));
    return header;
}

} // namespace core
