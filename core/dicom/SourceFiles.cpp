// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/SourceFiles.h"

#include "core/dicom/Dcmtk.h"

#include <QFile>
#include <QFileInfo>
#include <QHash>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

namespace {

Result<void> readFile(const QString& file, DcmFileFormat& format)
{
    if (!QFileInfo::exists(file))
        return failure(ErrorCode::FileNotFound, file);
    const OFCondition loaded = format.loadFileUntilTag(QFile::encodeName(file).constData(),
        EXS_Unknown, EGL_noChange, 1024, ERM_autoDetect, DCM_PixelData);
    if (loaded.bad())
        return failure(ErrorCode::FileUnreadable, file, QString::fromLatin1(loaded.text()));
    return {};
}

Result<void> readKept(const QString& file, const KeptHeaders& kept, DcmDataset& dataset)
{
    const auto found = kept.find(file);
    if (found == kept.end())
        return failure(ErrorCode::FileUnreadable, file,
            QStringLiteral("the session holds the image but not its header"));
    const QByteArray& bytes = found->second;
    DcmInputBufferStream stream;
    stream.setBuffer(bytes.constData(), offile_off_t(bytes.size()));
    stream.setEos();
    dataset.transferInit();
    const OFCondition read = dataset.read(stream, EXS_LittleEndianExplicit);
    dataset.transferEnd();
    if (read.bad())
        return failure(ErrorCode::FileUnreadable, file,
            QStringLiteral("of the header that the session holds: ")
                + QString::fromLatin1(read.text()));
    return {};
}

} // namespace

Result<void> visitSourceFiles(const std::vector<SourceSlice>& slices, const KeptHeaders* kept,
    const Progress& progress, const TakeSourceFile& take)
{
    readyDcmtk();
    QHash<QString, std::vector<std::size_t>> slicesOfFile;
    for (std::size_t k = 0; k < slices.size(); ++k)
        slicesOfFile[slices[k].file].push_back(k);

    int done = 0;
    for (auto it = slicesOfFile.cbegin(); it != slicesOfFile.cend(); ++it) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(QStringLiteral("Reading source headers"), done++, int(slicesOfFile.size()));
        const QString& file = it.key();
        DcmFileFormat format;
        const Result<void> read =
            kept != nullptr ? readKept(file, *kept, *format.getDataset()) : readFile(file, format);
        if (!read)
            return read;
        if (const Result<void> taken = take(file, *format.getDataset(), it.value()); !taken)
            return taken;
    }
    return {};
}

} // namespace core
