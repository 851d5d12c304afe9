// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/source/VisitSourceFiles.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/base/DicomFile.h"
#include "core/dicom/base/Preflight.h"

#include <QHash>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

namespace {

Result<void> readKept(const QString& file, const KeptHeaders& kept, DcmDataset& dataset)
{
    const auto found = kept.find(file);
    if (found == kept.end())
        return failure(ErrorCode::FileUnreadable, file,
            Clause::saying("the session holds the image but not its header"));
    const QByteArray& bytes = found->second;
    const DicomBytes dataSet(
        reinterpret_cast<const std::uint8_t*>(bytes.constData()), std::size_t(bytes.size()));
    if (const auto sound = preflight(dataSet, {}, file); !sound)
        return failure(ErrorCode::FileUnreadable, file,
            Clause::saying(
                "of the header that the session holds: %1", sound.error().arguments.value(1)));
    DcmInputBufferStream stream;
    stream.setBuffer(bytes.constData(), offile_off_t(bytes.size()));
    stream.setEos();
    dataset.transferInit();
    const OFCondition read = dataset.read(stream, EXS_LittleEndianExplicit);
    dataset.transferEnd();
    if (read.bad())
        return failure(ErrorCode::FileUnreadable, file,
            Clause::saying("of the header that the session holds: %1", QLatin1String(read.text())));
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
        progress.report(ProgressStep::ReadingSourceHeaders, done++, int(slicesOfFile.size()));
        const QString& file = it.key();
        DcmDataset dataset;
        const Result<void> read =
            kept != nullptr ? readKept(file, *kept, dataset) : DicomFile::readHeader(file, dataset);
        if (!read)
            return read;
        if (const Result<void> taken = take(file, dataset, it.value()); !taken)
            return taken;
    }
    return {};
}

} // namespace core
