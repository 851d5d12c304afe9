// SPDX-License-Identifier: Apache-2.0
#include "app/commands/CompareCommand.h"

#include "app/steps/Arguments.h"
#include "app/steps/JsonLine.h"
#include "core/measure/MeasuredSize.h"
#include "core/metrics/MaskComparison.h"
#include "core/metrics/SegmentPairs.h"
#include "core/study/StudyLoader.h"
#include "ui/texts/MaskTexts.h"

#include <algorithm>
#include <cstdio>

namespace app {

namespace {

/// Of both masks, as they lie on the study's grid.
struct Compared {
    core::MaskOnVolume mask;
    core::MaskOnVolume reference;
};

QJsonValue number(const std::optional<double>& value)
{
    return value ? QJsonValue(*value) : QJsonValue();
}

QString text(const std::optional<double>& value, const char* unit)
{
    return value ? QString::number(*value, 'f', 3) + QLatin1Char(' ') + QLatin1String(unit)
                 : QStringLiteral("–");
}

void print(const QString& segment, const QString& reference, const core::MaskComparison& comparison,
    bool asJson)
{
    const auto& apart = comparison.distances;
    const auto distance = [&apart](double core::SurfaceDistances::*which) {
        return apart ? std::optional((*apart).*which) : std::nullopt;
    };
    const auto hd95 = distance(&core::SurfaceDistances::hausdorff95Mm);
    const auto hausdorff = distance(&core::SurfaceDistances::hausdorffMm);
    const auto mean = distance(&core::SurfaceDistances::meanMm);
    const std::optional<double>& error = comparison.relativeVolumeError;
    if (asJson) {
        printJsonLine(
            {{QStringLiteral("segment"), segment}, {QStringLiteral("reference"), reference},
                {QStringLiteral("voxels"), qint64(comparison.voxels)},
                {QStringLiteral("referenceVoxels"), qint64(comparison.referenceVoxels)},
                {QStringLiteral("sharedVoxels"), qint64(comparison.sharedVoxels)},
                {QStringLiteral("rVE"), number(error)}, {QStringLiteral("dice"), comparison.dice},
                {QStringLiteral("hd95Mm"), number(hd95)},
                {QStringLiteral("hausdorffMm"), number(hausdorff)},
                {QStringLiteral("meanSurfaceDistanceMm"), number(mean)}});
        return;
    }
    constexpr double percent = 100.0;
    std::printf("%s against %s\n", qUtf8Printable(segment), qUtf8Printable(reference));
    std::printf("  voxels                 %llu, reference %llu, shared %llu\n",
        static_cast<unsigned long long>(comparison.voxels),
        static_cast<unsigned long long>(comparison.referenceVoxels),
        static_cast<unsigned long long>(comparison.sharedVoxels));
    const auto inPercent = error ? std::optional(*error * percent) : std::nullopt;
    std::printf("  relative volume error  %s\n", qUtf8Printable(text(inPercent, "%")));
    std::printf("  Dice                   %.4f\n", comparison.dice);
    std::printf("  surfaces apart         mean %s, 95 %% within %s, at most %s\n",
        qUtf8Printable(text(mean, "mm")), qUtf8Printable(text(hd95, "mm")),
        qUtf8Printable(text(hausdorff, "mm")));
}

void reportNotes(const QString& path, const std::vector<core::MaskNote>& notes)
{
    for (const core::MaskNote& note : notes)
        std::fprintf(
            stderr, "%s: %s\n", qUtf8Printable(path), qUtf8Printable(ui::maskNoteText(note)));
}

QString namesOf(const std::vector<core::MaskSegment>& segments)
{
    QStringList names;
    for (const core::MaskSegment& segment : segments)
        names.append(segment.name);
    return names.join(QStringLiteral(", "));
}

/// Segments that are in one of the masks alone are told, or a structure that one of them lacks
/// would be missing without a word.
void reportLeftOver(const QString& path, const std::vector<core::MaskSegment>& segments,
    const std::vector<core::SegmentPair>& pairs, std::size_t core::SegmentPair::*which)
{
    QStringList names;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (std::none_of(pairs.begin(), pairs.end(),
                [i, which](const core::SegmentPair& pair) { return pair.*which == i; }))
            names.append(segments[i].name);
    }
    if (!names.isEmpty())
        std::fprintf(stderr, "%s: not compared, as the other mask has no counterpart: %s\n",
            qUtf8Printable(path), qUtf8Printable(names.join(QStringLiteral(", "))));
}

core::Result<Compared> readBoth(const QStringList& paths, const core::Volume& volume)
{
    core::Result<core::MaskOnVolume> mask = core::readMask(paths[0], volume, {});
    if (!mask)
        return tl::unexpected(mask.error());
    core::Result<core::MaskOnVolume> reference = core::readMask(paths[1], volume, {});
    if (!reference)
        return tl::unexpected(reference.error());
    return Compared{.mask = std::move(*mask), .reference = std::move(*reference)};
}

int runCompare(const Arguments& arguments)
{
    const QStringList paths = arguments.rest();
    if (paths.size() != 2 || !arguments.has("study"))
        return reportUsageError(
            "compare", QStringLiteral("it needs two masks and --study, whose grid they lie on"));
    if (const QString wrong = repairProblem(arguments); !wrong.isEmpty())
        return reportUsageError("compare", wrong);
    const QString study = arguments.value("study");
    const auto loaded = core::loadVolume(study, seriesOf(arguments));
    if (!loaded)
        return reportFailure(loaded.error());
    reportProblems(loaded->volume, study);
    const core::Result<Compared> both = readBoth(paths, loaded->volume);
    if (!both)
        return reportFailure(both.error());
    reportNotes(paths[0], both->mask.notes);
    reportNotes(paths[1], both->reference.notes);

    const std::vector<core::MaskSegment>& segments = both->mask.segments;
    const std::vector<core::MaskSegment>& references = both->reference.segments;
    const std::vector<core::SegmentPair> pairs = core::segmentPairs(segments, references,
        {.segment = arguments.value("segment"), .reference = arguments.value("reference")});
    if (pairs.empty())
        return reportFailure({.code = core::ErrorCode::UnsupportedFormat,
            .arguments = {paths[0],
                QStringLiteral("its segments (%1) have no counterpart in %2 (%3); --segment and "
                               "--reference say which belong together")
                    .arg(namesOf(segments), paths[1], namesOf(references))}});
    if (!arguments.has("segment") && !arguments.has("reference")) {
        reportLeftOver(paths[0], segments, pairs, &core::SegmentPair::segment);
        reportLeftOver(paths[1], references, pairs, &core::SegmentPair::reference);
    }
    const bool isMeasured = core::unknownSpacing(loaded->volume) == core::UnknownSpacing::Nothing;
    for (const core::SegmentPair& pair : pairs) {
        const core::MaskSegment& segment = segments[pair.segment];
        const core::MaskSegment& reference = references[pair.reference];
        core::Result<core::MaskComparison> comparison = core::compareMasks(
            segment.voxels, reference.voxels, loaded->volume.geometry, core::Progress());
        if (!comparison)
            return reportFailure(comparison.error());
        // Where the spacing is unknown, nobody has measured millimetres.
        if (!isMeasured)
            comparison->distances.reset();
        print(segment.name, reference.name, *comparison, arguments.has("json"));
    }
    return 0;
}

} // namespace

const Command compareCommand{.name = "compare",
    .words = "MASK REFERENCE",
    .usage = "MASK REFERENCE --study PATH [--series UID] [--repair REPAIRS] [--segment NAME]"
             " [--reference NAME] [--json]",
    .summary = "measures how far a mask is from a reference mask: relative volume error, Dice, and "
               "distances of the surfaces in mm; masks may be of any format and are compared on "
               "the study's grid; --json prints a line for each pair of segments",
    .options = std::vector<Option>{{"study", "PATH", "the study, as a file or folder"},
                   {"segment", "NAME", "which segment of the mask is compared; all by default"},
                   {"reference", "NAME", "with which segment of the reference it is compared"},
                   {"json", nullptr, "prints a line of JSON for each pair of segments"}}
        + seriesOptions(),
    .run = runCompare};

} // namespace app
