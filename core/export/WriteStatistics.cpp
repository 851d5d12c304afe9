// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/write/SrWriter.h"
#include "core/export/common/StatisticsText.h"

#include <QFile>

namespace core {

namespace {

Result<void> writeText(const QString& path, const QByteArray& text)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate) || file.write(text) != text.size()
        || !file.flush())
        return failure(ErrorCode::FileUnwritable, path, file.errorString());
    return {};
}

Result<void> writeReport(const QString& path, const Volume& volume, const ExportRequest& request,
    const std::vector<SegmentStatistics>& all, const StagedExport& seg, const Progress& progress,
    ExportReport& report)
{
    report.written += QStringLiteral("The DICOM SEG that it refers to: %1. %2")
                          .arg(seg.report.file, seg.report.written.join(QLatin1Char(' ')));
    report.checked += seg.report.checked;
    report.checked += QStringLiteral("SHA-256 of %1: %2").arg(seg.report.file, seg.report.sha256);
    SrContent content{.identity = volume.identity,
        .sources = volume.sources,
        .keptHeaders = volume.keptHeaders,
        .seg = seg.file.path(),
        .groups = {},
        .unit = volume.unit,
        .deidentifier = request.deidentifier};
    for (const SegmentStatistics& each : all)
        content.groups.push_back({.segment = each.segment,
            .volumeMl = each.millilitres,
            .surfaceMm2 = each.surfaceMm2,
            .minimum = each.minimum,
            .maximum = each.maximum,
            .mean = each.mean,
            .deviation = each.deviation,
            .median = each.median});
    const auto notes = writeSr(path, content, progress);
    if (!notes)
        return tl::unexpected(notes.error());
    report.cautions += *notes;
    return {};
}

} // namespace

QString segBeside(const QString& file)
{
    const bool ends = file.endsWith(QLatin1String(".dcm"), Qt::CaseInsensitive);
    return (ends ? file.chopped(4) : file) + QStringLiteral("-seg.dcm");
}

Result<QStringList> writeStatistics(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const StagedExport* seg,
    const Progress& progress, ExportReport& report)
{
    const auto all = segmentStatistics(volume, request, selection, progress);
    if (!all)
        return tl::unexpected(all.error());
    Result<void> written;
    switch (request.format) {
    case ExportFormat::Csv:
        written = writeText(path, statisticsCsv(*all, volume));
        break;
    case ExportFormat::Json:
        written = writeText(path,
            statisticsJson(*all, volume,
                request.deidentifier ? request.deidentifier->deidentified(volume.identity)
                                     : volume.identity));
        break;
    default:
        written = writeReport(path, volume, request, *all, *seg, progress, report);
    }
    if (!written)
        return tl::unexpected(written.error());
    if (volume.encoding.maxError > 0.0)
        report.cautions += QStringLiteral("Values are rounded by up to %1, as they are on screen.")
                               .arg(volume.encoding.maxError);
    if (!volume.geometry.slicePositions.empty())
        report.cautions += QStringLiteral("The slices are not evenly spaced: in volumes each "
                                          "counts half the way to either neighbour.");
    QStringList names;
    for (const SegmentStatistics& each : *all)
        names +=
            QStringLiteral("%1 (%2 mL)").arg(each.segment.name).arg(each.millilitres, 0, 'f', 3);
    return QStringList{QStringLiteral("%1: %2.").arg(
        QLatin1String(factsOf(request.format).title), names.join(QStringLiteral(", ")))};
}

} // namespace core
