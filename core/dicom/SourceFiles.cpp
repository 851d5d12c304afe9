// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/SourceFiles.h"

#include "core/dicom/Dcmtk.h"

#include <QFile>
#include <QFileInfo>
#include <QHash>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

Result<void> visitSourceFiles(
    const std::vector<SourceSlice>& slices, const Progress& progress, const TakeSourceFile& take)
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
        if (!QFileInfo::exists(file))
            return failure(ErrorCode::FileNotFound, file);
        DcmFileFormat format;
        const OFCondition loaded = format.loadFileUntilTag(QFile::encodeName(file).constData(),
            EXS_Unknown, EGL_noChange, 1024, ERM_autoDetect, DCM_PixelData);
        if (loaded.bad())
            return failure(ErrorCode::FileUnreadable, file, QString::fromLatin1(loaded.text()));
        if (const Result<void> taken = take(file, *format.getDataset(), it.value()); !taken)
            return taken;
    }
    return {};
}

} // namespace core
