// SPDX-License-Identifier: Apache-2.0
#include "app/commands/InfoCommand.h"

#include "app/steps/Arguments.h"
#include "core/repair/SeriesFindings.h"
#include "core/study/StudyLoader.h"
#include "core/study/VolumeFacts.h"
#include "core/volume/MemoryLimit.h"
#include "gpu/engine/GpuEngine.h"
#include "gpu/engine/MemoryFormula.h"
#include "ui/base/ErrorText.h"
#include "ui/texts/ClauseText.h"
#include "ui/texts/ProblemTexts.h"
#include "ui/texts/RepairTexts.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cstdio>
#include <functional>
#include <vector>

namespace app {

namespace {

void print(FILE* out, const QString& line)
{
    std::fprintf(out, "%s\n", qUtf8Printable(line));
}

QJsonArray array(const glm::dvec3& vector)
{
    return {vector.x, vector.y, vector.z};
}

const core::VolumeGeometry& geometryOf(const core::VolumeFacts& facts)
{
    return facts.loaded ? facts.loaded->volume.geometry : facts.entry.geometry;
}

const std::vector<core::VolumeProblem>& problemsOf(const core::VolumeFacts& facts)
{
    return facts.loaded ? facts.loaded->volume.problems : facts.entry.problems;
}

/// Pictures without a spacing wait for one; that stands among the findings.
bool failed(const core::VolumeFacts& facts)
{
    return !facts.loaded && !(facts.entry.needsSpacing() && facts.repair.isEmpty());
}

std::vector<core::SeriesFinding> findingsOf(
    const core::Study& study, const core::VolumeFacts& facts)
{
    return facts.loaded ? core::seriesFindings(facts.loaded->volume)
                        : core::seriesFindings(study.listing(), facts.entry);
}

QStringList problemTexts(const core::VolumeFacts& facts)
{
    QStringList texts;
    for (const core::VolumeProblem& problem : problemsOf(facts))
        texts.append(ui::problemText(problem.said));
    if (failed(facts))
        texts.append(ui::errorText(facts.loaded.error()));
    return texts;
}

QJsonArray json(const std::vector<core::TimeFacts>& times)
{
    QJsonArray list;
    for (const core::TimeFacts& time : times) {
        list.append(QJsonObject{{QStringLiteral("seriesUid"), time.key},
            {QStringLiteral("label"), time.label}, {QStringLiteral("min"), time.minimum},
            {QStringLiteral("max"), time.maximum},
            {QStringLiteral("voxelsSha256"), QString::fromLatin1(time.voxelsSha256)}});
    }
    return list;
}

QJsonObject json(const core::RepairOffer& offer)
{
    const core::VolumeGeometry& grid = offer.result;
    QJsonObject object{{QStringLiteral("title"), ui::repairTitle(offer)},
        {QStringLiteral("effect"), ui::repairEffect(offer)},
        {QStringLiteral("size"), QJsonArray{grid.size.x, grid.size.y, grid.size.z}},
        {QStringLiteral("spacingMm"), array(grid.spacingMm())}};
    if (offer.repair.isEmpty())
        object.insert(QStringLiteral("series"), offer.series);
    else
        object.insert(QStringLiteral("repair"), offer.repair);
    return object;
}

QJsonArray json(const std::vector<core::SeriesFinding>& findings)
{
    QJsonArray list;
    for (const core::SeriesFinding& finding : findings) {
        QJsonArray slices;
        for (const core::SliceSpan& span : finding.problem.slices)
            slices.append(QJsonArray{span.first, span.last});
        QJsonArray repairs;
        for (const core::RepairOffer& offer : finding.offers)
            repairs.append(json(offer));
        QJsonObject object{{QStringLiteral("text"), ui::problemText(finding.problem.said)},
            {QStringLiteral("caution"), finding.problem.caution},
            {QStringLiteral("slices"), slices}, {QStringLiteral("repairs"), repairs}};
        if (!finding.problem.repairedBy.isEmpty())
            object.insert(QStringLiteral("repairedBy"), finding.problem.repairedBy);
        list.append(object);
    }
    return list;
}

QJsonObject json(const core::Study& study, const core::VolumeFacts& facts)
{
    const core::VolumeGeometry& geometry = geometryOf(facts);
    const glm::dmat3 axes = geometry.direction();
    QJsonArray direction;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            direction.append(axes[column][row]);
    }
    QJsonObject object{{QStringLiteral("seriesUid"), facts.entry.key},
        {QStringLiteral("modality"), facts.entry.identity.modality},
        {QStringLiteral("description"), facts.entry.identity.seriesDescription},
        {QStringLiteral("size"), QJsonArray{geometry.size.x, geometry.size.y, geometry.size.z}},
        {QStringLiteral("spacingMm"), array(geometry.spacingMm())},
        {QStringLiteral("originLps"), array(geometry.originLps())},
        {QStringLiteral("directionLps"), direction}, {QStringLiteral("unit"), facts.entry.unit},
        {QStringLiteral("problems"), QJsonArray::fromStringList(problemTexts(facts))},
        {QStringLiteral("findings"), json(findingsOf(study, facts))}};
    if (facts.loaded && !facts.loaded->volume.repair.isEmpty())
        object.insert(QStringLiteral("repair"), facts.loaded->volume.repair);
    if (facts.loaded) {
        object.insert(QStringLiteral("min"), facts.minimum);
        object.insert(QStringLiteral("max"), facts.maximum);
        if (!facts.voxelsSha256.isEmpty())
            object.insert(QStringLiteral("voxelsSha256"), QString::fromLatin1(facts.voxelsSha256));
    }
    if (!facts.times.empty())
        object.insert(QStringLiteral("times"), json(facts.times));
    return object;
}

/// What of it is looked at, and how it is repaired.
struct Asked {
    const core::Study& study;
    QString series; ///< empty: all of them
    QString repair;

    [[nodiscard]] bool covers(const core::SeriesEntry& entry) const
    {
        return series.isEmpty() || entry.key == series || entry.identity.seriesUid == series;
    }
};

/// Loads volume after volume, one at a time in memory.
bool forEachVolume(const Asked& asked,
    const std::function<void(const core::StudyEntry&, const core::VolumeFacts&)>& visit)
{
    bool sound = true;
    for (const core::StudyEntry& one : asked.study.listing().studies) {
        for (const core::SeriesEntry& entry : one.series) {
            if (!asked.covers(entry))
                continue;
            const core::VolumeFacts facts = core::volumeFacts(asked.study, entry, asked.repair);
            if (failed(facts)) {
                sound = false;
                reportFailure(facts.loaded.error());
            }
            visit(one, facts);
        }
    }
    return sound;
}

/// What else lies there and why it is no volume, in words.
QStringList refusals(const core::StudyListing& listing)
{
    QStringList lines;
    for (const core::ForeignObject& object : listing.foreign) {
        lines.append(QStringLiteral("%1 × %2%3  %4")
                         .arg(object.files.size())
                         .arg(ui::clauseText(object.kind),
                             object.reason.isEmpty()
                                 ? QString()
                                 : QStringLiteral(" (%1)").arg(ui::clauseText(object.reason)),
                             QFileInfo(object.files.front()).fileName()));
    }
    for (const core::UnreadableFile& file : listing.unreadable)
        lines.append(QStringLiteral("not read: %1").arg(ui::errorText(file.error)));
    return lines;
}

int printJson(const Asked& asked)
{
    QJsonArray studies;
    const core::StudyEntry* current = nullptr;
    QJsonArray series;
    const auto close = [&] {
        if (current) {
            studies.append(QJsonObject{{QStringLiteral("studyUid"), current->studyUid},
                {QStringLiteral("series"), series}});
        }
        series = {};
    };
    const bool sound =
        forEachVolume(asked, [&](const core::StudyEntry& study, const core::VolumeFacts& facts) {
            if (&study != current)
                close();
            current = &study;
            series.append(json(asked.study, facts));
        });
    close();
    const QJsonDocument document(QJsonObject{{QStringLiteral("studies"), studies},
        {QStringLiteral("problems"), QJsonArray::fromStringList(refusals(asked.study.listing()))}});
    std::fputs(document.toJson(QJsonDocument::Indented).constData(), stdout);
    return sound ? 0 : 1;
}

void printOffer(const core::RepairOffer& offer)
{
    const core::VolumeGeometry& grid = offer.result;
    const QString option = offer.repair.isEmpty() ? QStringLiteral("--series %1").arg(offer.series)
                                                  : QStringLiteral("--repair %1").arg(offer.repair);
    print(stdout,
        QStringLiteral("    repair   %1: %2; %3 × %4 × %5, slices %6 mm apart")
            .arg(option, ui::repairTitle(offer))
            .arg(grid.size.x)
            .arg(grid.size.y)
            .arg(grid.size.z)
            .arg(grid.spacingMm().z, 0, 'g', 4));
}

void printFinding(const core::SeriesFinding& finding)
{
    const core::VolumeProblem& problem = finding.problem;
    const char* kind = problem.caution ? "caution  "
        : problem.repairedBy.isEmpty() ? "note     "
                                       : "repaired ";
    print(
        stdout, QStringLiteral("    %1%2").arg(QLatin1String(kind), ui::problemText(problem.said)));
    if (!problem.repairedBy.isEmpty())
        print(stdout, QStringLiteral("             by --repair %1").arg(problem.repairedBy));
    for (const core::RepairOffer& offer : finding.offers) {
        if (problem.repairedBy.isEmpty())
            printOffer(offer);
    }
}

void printVolume(const core::Study& study, const core::VolumeFacts& facts)
{
    const core::StudyIdentity& identity = facts.entry.identity;
    const core::VolumeGeometry& geometry = geometryOf(facts);
    const glm::dvec3 spacing = geometry.spacingMm();
    const QString part = facts.entry.part.isEmpty()
        ? QString()
        : QStringLiteral(" (%1)").arg(ui::clauseText(facts.entry.part));
    print(stdout,
        QStringLiteral("  %1 %2%3").arg(identity.modality, identity.seriesDescription, part));
    print(stdout, QStringLiteral("    series   %1").arg(facts.entry.key));
    print(stdout,
        QStringLiteral("    voxels   %1 × %2 × %3 of %4 × %5 × %6 mm")
            .arg(geometry.size.x)
            .arg(geometry.size.y)
            .arg(geometry.size.z)
            .arg(spacing.x, 0, 'g', 6)
            .arg(spacing.y, 0, 'g', 6)
            .arg(spacing.z, 0, 'g', 6));
    if (!facts.loaded && !failed(facts))
        print(stdout,
            QStringLiteral("             to be given in mm: --spacing COLUMNS,ROWS,SLICES"));
    if (facts.loaded) {
        const core::Volume& volume = facts.loaded->volume;
        print(stdout,
            QStringLiteral("    values   %1 … %2 %3")
                .arg(facts.minimum)
                .arg(facts.maximum)
                .arg(volume.unit));
    }
    if (!facts.times.empty())
        print(stdout, QStringLiteral("    times    %1").arg(facts.times.size()));
    for (const core::TimeFacts& time : facts.times) {
        print(stdout,
            QStringLiteral("             %1  %2 … %3  %4")
                .arg(time.key)
                .arg(time.minimum)
                .arg(time.maximum)
                .arg(ui::clauseText(time.label)));
    }
    for (const core::SeriesFinding& finding : findingsOf(study, facts))
        printFinding(finding);
    if (failed(facts))
        print(stdout, QStringLiteral("    failed   %1").arg(ui::errorText(facts.loaded.error())));
}

int printText(const Asked& asked)
{
    const core::StudyEntry* current = nullptr;
    const bool sound =
        forEachVolume(asked, [&](const core::StudyEntry& study, const core::VolumeFacts& facts) {
            if (&study != current) {
                const core::StudyIdentity& of = facts.entry.identity;
                print(stdout,
                    QStringLiteral("%1  %2  born %3  study of %4  %5")
                        .arg(
                            of.patientName.isEmpty() ? QStringLiteral("(no name)") : of.patientName,
                            of.patientId.isEmpty() ? QStringLiteral("(no ID)") : of.patientId,
                            of.birthDate.isEmpty() ? QStringLiteral("(unknown)") : of.birthDate,
                            of.studyDate.isEmpty() ? QStringLiteral("(unknown)") : of.studyDate,
                            of.studyDescription));
            }
            current = &study;
            printVolume(asked.study, facts);
        });
    for (const QString& line : refusals(asked.study.listing()))
        print(stdout, line);
    return sound ? 0 : 1;
}

QString mebibytes(std::size_t bytes)
{
    return QString::number(double(bytes) / (1024.0 * 1024.0), 'f', 1);
}

int printGraphics()
{
    const auto engine = gpu::GpuEngine::create();
    if (!engine) {
        print(stderr, QStringLiteral("burin: ") + ui::errorText(engine.error()));
        return 1;
    }
    print(stdout, QStringLiteral("GL_RENDERER  ") + (*engine)->rendererName());
    print(stdout, QStringLiteral("GL_VERSION   ") + (*engine)->versionText());
    print(stdout, QStringLiteral("memory       ") + gpu::MemoryFormula::text());
    for (const glm::ivec3& size : {glm::ivec3(256, 256, 200), glm::ivec3(512), glm::ivec3(1024)}) {
        QStringList parts;
        for (const gpu::MemoryFormula::Part& part : gpu::MemoryFormula::denseParts(size))
            parts << QStringLiteral("%1 %2").arg(part.name, mebibytes(part.bytes));
        print(stdout,
            QStringLiteral("             %1 × %2 × %3: %4 MiB dense (%5)")
                .arg(size.x)
                .arg(size.y)
                .arg(size.z)
                .arg(mebibytes(gpu::MemoryFormula::denseBytes(size)),
                    parts.join(QStringLiteral(", "))));
    }
    print(stdout,
        QStringLiteral("allowed      %1 MiB of this machine's memory: voxels × 2 while a volume is "
                       "read, and with a driver that computes on the processor all of the above")
            .arg(mebibytes(std::size_t(core::allowedBytes()))));
    return 0;
}

int runInfo(const Arguments& arguments)
{
    if (const QString wrong = repairProblem(arguments); !wrong.isEmpty())
        return reportUsageError("info", wrong);
    const QStringList& paths = arguments.rest();
    if (arguments.has("gl")) {
        if (arguments.optionCount() > 1 || !paths.isEmpty())
            return reportUsageError("info", QStringLiteral("--gl stands alone"));
        return printGraphics();
    }
    if (paths.size() != 1)
        return reportUsageError("info",
            paths.isEmpty() ? QStringLiteral("PATH is missing")
                            : QStringLiteral("unexpected argument '%1'").arg(paths[1]));
    const core::Result<core::Study> study = core::Study::scan(paths.front());
    if (!study)
        return reportFailure(study.error());
    const core::SeriesChoice choice = study->listing().choice(seriesOf(arguments));
    const Asked asked{.study = *study, .series = choice.series, .repair = choice.repair};
    if (!asked.series.isEmpty() && study->listing().matching(asked.series).empty())
        return reportFailure(
            {core::ErrorCode::SeriesNotFound, {paths.front(), arguments.value("series")}});
    return arguments.has("json") ? printJson(asked) : printText(asked);
}

} // namespace

const Command infoCommand{.name = "info",
    .words = "PATH",
    .usage = "PATH [--series UID] [--repair REPAIRS] [--spacing COLUMNS,ROWS,SLICES] [--json]"
             " | --gl",
    .summary = "tells what a file or folder holds: its studies and volumes, what is wrong with "
               "them and how that can be repaired; with --repair, how they would open",
    .options = std::vector<Option>{{"json", nullptr, "prints it as JSON"},
                   {"gl", nullptr, "prints only which graphics driver draws on this machine"}}
        + seriesOptions() + spacingOption(),
    .run = runInfo};

} // namespace app
