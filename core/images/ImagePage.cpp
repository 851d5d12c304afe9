// SPDX-License-Identifier: Apache-2.0
#include "core/images/ImagePage.h"

#include "core/images/PngHeader.h"
#include "core/images/TiffDirectory.h"

#include <QByteArray>
#include <QFile>

namespace core {

namespace {

constexpr qint64 dicomMarkAt = 128;
constexpr qint64 firstBytes = dicomMarkAt + 4;

QByteArray beginningOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.read(firstBytes) : QByteArray();
}

} // namespace

QString ImagePage::inWords() const
{
    const bool isSigned =
        type == ScalarType::Int8 || type == ScalarType::Int16 || type == ScalarType::Int32;
    const QString kind = isFloating(type) ? QStringLiteral(" floating point")
        : isSigned                        ? QStringLiteral(" signed")
                                          : QString();
    return QStringLiteral("%1 × %2 of %3 bits%4%5")
        .arg(columns)
        .arg(rows)
        .arg(8 * bytesPerScalar(type))
        .arg(kind, isInverted ? QStringLiteral(", 0 is white") : QString());
}

bool isImageName(const QString& path)
{
    // Hidden ones are what other systems leave beside a picture ("._slice1.png").
    if (path.mid(path.lastIndexOf(u'/') + 1).startsWith(u'.'))
        return false;
    for (const char* ending : {".png", ".tif", ".tiff"}) {
        if (path.endsWith(QLatin1String(ending), Qt::CaseInsensitive))
            return true;
    }
    return false;
}

FirstBytes firstBytesOf(const QString& path)
{
    const QByteArray begin = beginningOf(path);
    if (begin.mid(dicomMarkAt) == "DICM")
        return FirstBytes::Dicom;
    return isPng(begin) || isTiff(begin) ? FirstBytes::Image : FirstBytes::Other;
}

Result<std::vector<ImagePage>> readImagePages(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    const QByteArray begin = file.peek(firstBytes);
    if (begin.isEmpty())
        return failure(ErrorCode::FileTruncated, path, Clause::saying("it holds no bytes"));
    if (isTiff(begin))
        return readTiffPages(file);
    if (!isPng(begin))
        return failure(ErrorCode::FileUnreadable, path, Clause::saying("not a PNG or TIFF file"));
    Result<ImagePage> page = readPngHeader(file);
    if (!page)
        return tl::unexpected<Error>(page.error());
    return std::vector<ImagePage>{*std::move(page)};
}

} // namespace core
