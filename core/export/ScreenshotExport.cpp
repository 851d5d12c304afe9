// SPDX-License-Identifier: Apache-2.0
#include "core/export/ScreenshotExport.h"

#include "core/base/files/StagedFile.h"
#include "core/export/common/CheckSources.h"
#include "core/export/common/MaskSelection.h"

#include <QByteArrayView>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace core {

namespace {

Result<ReportLines> check(const QString& path, const Volume& volume, const ScreenPicture& picture,
    const Progress& progress)
{
    const auto mismatch = [&](const Clause& what) {
        return failure(ErrorCode::ExportMismatch, path, what);
    };
    const auto read = readSecondaryCapture(path);
    if (!read)
        return tl::unexpected(read.error());
    const auto headers =
        readSourceHeaders({volume.sources.front()}, volume.keptHeaders.get(), progress);
    if (!headers)
        return tl::unexpected(headers.error());
    const SourceHeader& header = headers->front();
    if (const Clause what = differenceFromSource(read->patient, header.patient); !what.isEmpty())
        return mismatch(what);
    if (read->studyUid != header.studyUid || read->studyUid != volume.identity.studyUid)
        return mismatch(Clause::saying("the study"));
    if (read->seriesUid == header.seriesUid)
        return mismatch(Clause::saying("the series is not a new one"));
    if (read->width != picture.width || read->height != picture.height
        || !std::equal(read->rgb.begin(), read->rgb.end(), picture.rgb.begin(), picture.rgb.end()))
        return mismatch(Clause::saying("the pixels"));
    return ReportLines{ReportSentence{ReportCode::PixelsAgree, {picture.width, picture.height}}};
}

Error renamed(Error error, const StagedFile& staged, const QString& file)
{
    error.arguments.exchange(staged.path(), file);
    return error;
}

} // namespace

Result<ExportReport> exportScreenshot(
    const Volume& volume, const ScreenshotRequest& request, const Progress& progress)
{
    if (const Clause obstacle = dicomSegObstacle(volume); !obstacle.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, request.file,
            Clause::saying("the study does not say to which patient and study a Secondary Capture "
                           "would belong; a PNG can be written"));
    if (isSourceFile(volume, request.file))
        return failure(ErrorCode::FileUnwritable, request.file,
            Clause::saying("it is a file of the study itself"));
    auto staged = StagedFile::create(request.file, request.force);
    if (!staged)
        return tl::unexpected(staged.error());
    const auto notes = writeSecondaryCapture(staged->path(),
        {.identity = volume.identity,
            .sources = volume.sources,
            .keptHeaders = volume.keptHeaders,
            .picture = request.picture},
        progress);
    if (!notes)
        return tl::unexpected(renamed(notes.error(), *staged, request.file));
    const auto checked = check(staged->path(), volume, request.picture, progress);
    if (!checked)
        return tl::unexpected(renamed(checked.error(), *staged, request.file));
    ExportReport report;
    report.file = request.file;
    report.written += ReportSentence{
        ReportCode::SecondaryCapture, {request.picture.width, request.picture.height}};
    report.checked = *checked;
    report.cautions = *notes;
    const auto sum = sha256OfFile(staged->path());
    if (!sum)
        return tl::unexpected(renamed(sum.error(), *staged, request.file));
    report.sha256 = *sum;
    if (auto done = staged->commit(); !done)
        return tl::unexpected(done.error());
    return report;
}

Result<void> checkPictureTarget(const QString& file)
{
    constexpr QByteArrayView pngSignature("\x89PNG\r\n\x1a\n");
    if (const Result<void> target = checkFileTarget(file, true); !target)
        return target;
    if (QFileInfo(file).size() == 0)
        return {};
    if (file.endsWith(QLatin1String(".dcm"), Qt::CaseInsensitive)) {
        if (!readSecondaryCapture(file))
            return failure(ErrorCode::FileUnwritable, file,
                Clause::saying("it is no Secondary Capture, and nothing else is replaced by one"));
        return {};
    }
    QFile there(file);
    if (!there.open(QIODevice::ReadOnly) || there.read(pngSignature.size()) != pngSignature)
        return failure(ErrorCode::FileUnwritable, file,
            Clause::saying("it is no PNG picture, and nothing else is replaced by one"));
    return {};
}

} // namespace core
