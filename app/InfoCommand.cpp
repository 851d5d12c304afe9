// SPDX-License-Identifier: Apache-2.0
#include "app/InfoCommand.h"

#include "core/study/StudyLoader.h"
#include "core/study/VolumeFacts.h"
#include "gpu/GpuEngine.h"
#include "gpu/MemoryFormula.h"
#include "ui/ErrorText.h"

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

QStringList problemTexts(const core::VolumeFacts& facts)
{
    QStringList texts;
    for (const core::VolumeProblem& problem : problemsOf(facts))
        texts.append(problem.text);
    if (!facts.loaded)
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

QJsonObject json(const core::VolumeFacts& facts)
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
        {QStringLiteral("problems"), QJsonArray::fromStringList(problemTexts(facts))}};
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

/// Loads volume after volume, one at a time in memory.
bool forEachVolume(const core::Study& study,
    const std::function<void(const core::StudyEntry&, const core::VolumeFacts&)>& visit)
{
    bool sound = true;
    for (const core::StudyEntry& one : study.listing().studies) {
        for (const core::SeriesEntry& entry : one.series) {
            const core::VolumeFacts facts = core::volumeFacts(study, entry);
            sound = sound && facts.loaded.has_value();
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
                         .arg(object.kind,
                             object.reason.isEmpty() ? QString()
                                                     : QStringLiteral(" (%1)").arg(object.reason),
                             QFileInfo(object.files.front()).fileName()));
    }
    for (const core::UnreadableFile& file : listing.unreadable)
        lines.append(QStringLiteral("not read: %1").arg(ui::errorText(file.error)));
    return lines;
}

int printJson(const core::Study& source)
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
        forEachVolume(source, [&](const core::StudyEntry& study, const core::VolumeFacts& facts) {
            if (&study != current)
                close();
            current = &study;
            series.append(json(facts));
        });
    close();
    const QJsonDocument document(QJsonObject{{QStringLiteral("studies"), studies},
        {QStringLiteral("problems"), QJsonArray::fromStringList(refusals(source.listing()))}});
    std::fputs(document.toJson(QJsonDocument::Indented).constData(), stdout);
    return sound ? 0 : 1;
}

void printVolume(const core::VolumeFacts& facts)
{
    const core::StudyIdentity& identity = facts.entry.identity;
    const core::VolumeGeometry& geometry = geometryOf(facts);
    const glm::dvec3 spacing = geometry.spacingMm();
    const QString part =
        facts.entry.part.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(facts.entry.part);
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
                .arg(time.label));
    }
    for (const core::VolumeProblem& problem : problemsOf(facts)) {
        print(stdout,
            QStringLiteral("    %1%2")
                .arg(QLatin1String(problem.caution ? "caution  " : "note     "), problem.text));
    }
    if (!facts.loaded)
        print(stdout, QStringLiteral("    failed   %1").arg(ui::errorText(facts.loaded.error())));
}

int printText(const core::Study& source)
{
    const core::StudyEntry* current = nullptr;
    const bool sound =
        forEachVolume(source, [&](const core::StudyEntry& study, const core::VolumeFacts& facts) {
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
            printVolume(facts);
        });
    for (const QString& line : refusals(source.listing()))
        print(stdout, line);
    return sound ? 0 : 1;
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
    for (const glm::ivec3& size : {glm::ivec3(256, 256, 200), glm::ivec3(512, 512, 512)}) {
        print(stdout,
            QStringLiteral("             %1 × %2 × %3: %4 MiB dense")
                .arg(size.x)
                .arg(size.y)
                .arg(size.z)
                .arg(double(gpu::MemoryFormula::denseBytes(size)) / (1024.0 * 1024.0), 0, 'f', 1));
    }
    return 0;
}

} // namespace

int runInfo(const QStringList& arguments)
{
    bool asJson = false;
    bool graphics = false;
    QString path;
    for (const QString& argument : arguments) {
        if (argument == QLatin1String("--gl")) {
            graphics = true;
        } else if (argument == QLatin1String("--json")) {
            asJson = true;
        } else if (argument.startsWith(QLatin1String("--")) || !path.isEmpty()) {
            print(stderr, QStringLiteral("burin info: unexpected argument '%1'").arg(argument));
            return 2;
        } else {
            path = argument;
        }
    }
    if (graphics && (asJson || !path.isEmpty())) {
        print(stderr, QStringLiteral("burin info: --gl stands alone"));
        return 2;
    }
    if (graphics)
        return printGraphics();
    if (path.isEmpty()) {
        print(stderr, QStringLiteral("burin info: PATH is missing"));
        return 2;
    }
    const core::Result<core::Study> study = core::Study::scan(path);
    if (!study) {
        print(stderr, QStringLiteral("burin: ") + ui::errorText(study.error()));
        return 1;
    }
    return asJson ? printJson(*study) : printText(*study);
}

} // namespace app
