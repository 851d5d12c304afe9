// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/write/SrWriter.h"
#include "core/export/common/StatisticsText.h"
#include "core/measure/MeasuredSize.h"

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
    ReportSentence::Listed written{.joiner = ReportCode::Space};
    for (const ReportLine& line : seg.report.written) {
        // A problem of the volume is a caution, and never stands here.
        if (const auto* own = std::get_if<ReportSentence>(&line))
            written.all.push_back(*own);
    }
    report.written += ReportSentence{ReportCode::SegBeside, {seg.report.file, std::move(written)}};
    report.checked += seg.report.checked;
    report.checked += ReportSentence{ReportCode::Sha256, {seg.report.file, seg.report.sha256}};
    SrContent content{.identity = volume.identity,
        .sources = volume.sources,
        .keptHeaders = volume.keptHeaders,
        .seg = seg.file.path(),
        .groups = {},
        .measured = {},
        .geometry = volume.geometry,
        .unit = volume.unit,
        .sizesInVoxels = unknownSpacing(volume) != UnknownSpacing::Nothing,
        .deidentifier = request.deidentifier};
    for (const SegmentStatistics& each : all) {
        content.groups.push_back({.segment = each.segment,
            .voxels = each.voxels,
            .volumeMl = each.millilitres,
            .surfaceMm2 = each.surfaceMm2,
            .sphericity = each.sphericity,
            .longestMm = each.longestMm,
            .acrossMm = each.acrossMm,
            .minimum = each.minimum,
            .maximum = each.maximum,
            .mean = each.mean,
            .deviation = each.deviation,
            .median = each.median});
        if (const auto& since = each.sinceImport)
            content.groups.back().sinceImport = SrSinceImport{
                .addedMl = since->addedMl, .takenMl = since->takenMl, .dice = since->dice};
    }
    for (const Measurement& each : request.measurements)
        content.measured.push_back(measuredIn(each, volume, request.codes));
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

Result<ReportLines> writeStatistics(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const StagedExport* seg,
    const Progress& progress, ExportReport& report)
{
    const auto all = segmentStatistics(volume, request, selection, progress);
    if (!all)
        return tl::unexpected(all.error());
    Result<void> written;
    ReportCode format = ReportCode::SrFormat;
    switch (request.format) {
    case ExportFormat::Csv:
        format = ReportCode::CsvFormat;
        written = writeText(path, statisticsCsv(*all, volume));
        break;
    case ExportFormat::Json:
        format = ReportCode::JsonFormat;
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
        report.cautions +=
            ReportSentence{ReportCode::ValuesRounded, {QString::number(volume.encoding.maxError)}};
    if (!volume.geometry.slicePositions.empty())
        report.cautions += ReportSentence{ReportCode::UnevenInVolumes};
    // Millilitres that nobody measured are told nowhere.
    const bool isMeasured = unknownSpacing(volume) == UnknownSpacing::Nothing;
    std::vector<ReportSentence> volumes;
    for (const SegmentStatistics& each : *all) {
        if (isMeasured)
            volumes.push_back({ReportCode::VolumeOf,
                {each.segment.name, QString::number(each.millilitres, 'f', 3)}});
        else
            volumes.push_back({ReportCode::Quoted, {each.segment.name}});
    }
    ReportLines lines{ReportSentence{
        ReportCode::Statistics, {inReport(ReportSentence{format}), inReport(std::move(volumes))}}};
    for (const SegmentStatistics& each : *all) {
        if (each.sinceImport && isMeasured)
            lines += ReportSentence{ReportCode::SinceImport,
                {each.segment.name, QString::number(each.sinceImport->addedMl, 'f', 3),
                    QString::number(each.sinceImport->takenMl, 'f', 3),
                    QString::number(each.sinceImport->dice, 'f', 4)}};
    }
    return lines;
}

} // namespace core
