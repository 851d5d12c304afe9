// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/SourceHeader.h"

#include "core/dicom/Dcmtk.h"
#include "core/dicom/HeaderReading.h"

#include <QFile>
#include <QFileInfo>
#include <QHash>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <memory>

namespace core {

Result<std::vector<SourceHeader>> readSourceHeaders(
    const std::vector<SourceSlice>& slices, const Progress& progress)
{
    readyDcmtk();
    // Slices of one file need not follow each other; a multi-frame file is parsed once.
    QHash<QString, std::vector<std::size_t>> slicesOfFile;
    for (std::size_t k = 0; k < slices.size(); ++k)
        slicesOfFile[slices[k].file].push_back(k);

    std::vector<SourceHeader> headers(slices.size());
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
        DcmDataset* dataset = format.getDataset();
        const ItemReader reader(dataset);

        SourceHeader common;
        common.patient = readHeaderPatient(*dataset);
        common.studyUid = reader.text(DCM_StudyInstanceUID);
        common.seriesUid = reader.text(DCM_SeriesInstanceUID);
        common.frameOfReferenceUid = reader.text(DCM_FrameOfReferenceUID);
        common.sopInstanceUid = reader.text(DCM_SOPInstanceUID);
        common.rows = reader.integer(DCM_Rows).value_or(0);
        common.columns = reader.integer(DCM_Columns).value_or(0);
        for (const std::size_t k : it.value()) {
            const auto plane = readHeaderPlane(reader, slices[k].frame);
            if (!plane)
                return failure(ErrorCode::InvalidGeometry, file,
                    QStringLiteral("position, orientation or pixel spacing is missing"));
            headers[k] = common;
            headers[k].plane = *plane;
        }
    }
    return headers;
}

} // namespace core
