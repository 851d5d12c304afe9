// SPDX-License-Identifier: Apache-2.0
#include "core/images/PngHeader.h"

#include "core/images/ImageSpacing.h"
#include "core/voxelfile/InflateFile.h"

#include <QFile>
#include <QtEndian>

namespace core {

namespace {

const QByteArray mark("\x89PNG\r\n\x1a\n", 8);
constexpr qint64 chunkHead = 8;
constexpr qint64 chunkSum = 4;
constexpr qint64 headerChunk = 13;

/// PNG 1.2, 4.1.1: what a pixel is.
Clause colourReason(int colourType)
{
    switch (colourType) {
    case 0:
        return {};
    case 2:
        return Clause::saying("its pixels are colours (RGB); pictures in grey are read");
    case 3:
        return Clause::saying("its pixels are colours of a palette; pictures in grey are read");
    case 4:
        return Clause::saying("its pixels are grey with transparency; pictures in grey are read");
    case 6:
        return Clause::saying("its pixels are colours (RGBA); pictures in grey are read");
    default:
        return Clause::saying("its header names a colour type of %1", colourType);
    }
}

quint32 numberAt(const QByteArray& bytes, qsizetype at)
{
    return qFromBigEndian<quint32>(bytes.constData() + at);
}

Result<ImagePage> fromHeader(const QByteArray& header, const QString& path)
{
    const quint32 columns = numberAt(header, 0);
    const quint32 rows = numberAt(header, 4);
    const int depth = quint8(header[8]);
    if (columns < 1 || rows < 1 || columns > quint32(longestImageSide)
        || rows > quint32(longestImageSide))
        return failure(
            ErrorCode::InvalidGeometry, path, Clause::saying("%1 × %2 pixels", columns, rows));
    if (const Clause reason = colourReason(quint8(header[9])); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, path, reason);
    if (depth != 8 && depth != 16)
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("its pixels have %1 bits; 8 and 16 are read", depth));
    return ImagePage{.file = path,
        .form = ImagePage::Form::Png,
        .columns = int(columns),
        .rows = int(rows),
        .type = depth == 8 ? ScalarType::UInt8 : ScalarType::UInt16};
}

} // namespace

bool isPng(const QByteArray& begin)
{
    return begin.startsWith(mark);
}

Result<ImagePage> readPngHeader(QFile& file)
{
    const QString path = file.fileName();
    const auto truncated = [&] {
        return failure(ErrorCode::FileTruncated, path, Clause::saying("its pixels are incomplete"));
    };
    file.seek(mark.size());
    const QByteArray first = file.read(chunkHead + headerChunk + chunkSum);
    if (first.size() < chunkHead + headerChunk + chunkSum)
        return truncated();
    if (numberAt(first, 0) != headerChunk || first.mid(4, 4) != "IHDR")
        return failure(ErrorCode::FileUnreadable, path, Clause::saying("not a sound PNG header"));
    Result<ImagePage> page = fromHeader(first.mid(chunkHead, headerChunk), path);
    if (!page)
        return page;
    constexpr qint64 mostBytes = qint64(1) << 31;
    if (file.size() > mostBytes)
        return failure(
            ErrorCode::UnsupportedFormat, path, Clause::saying("more than 2 GB for one picture"));
    if (double(page->byteCount()) > InflateFile::greatestRatio * double(file.size()))
        return truncated();
    // What precedes the pixels; each chunk moves on by at least its head.
    for (QByteArray head = file.read(chunkHead); head.size() == chunkHead;
         head = file.read(chunkHead)) {
        const qint64 length = numberAt(head, 0);
        const QByteArray name = head.mid(4);
        if (length > file.size() - file.pos())
            return truncated();
        if (name == "IDAT")
            return page;
        constexpr qint64 physicalChunk = 9;
        if (name == "pHYs" && length == physicalChunk) {
            const QByteArray physical = file.peek(length);
            const bool isMetres = physical.size() == physicalChunk && physical[8] == 1;
            if (isMetres)
                setResolution(page->spacingMm, numberAt(physical, 0), numberAt(physical, 4),
                    millimetresPerMetre);
        }
        file.seek(file.pos() + length + chunkSum);
    }
    return truncated();
}

} // namespace core
