// SPDX-License-Identifier: Apache-2.0
#include "app/InfoCommand.h"

#include "core/study/StudyLoader.h"
#include "gpu/GpuEngine.h"
#include "gpu/MemoryFormula.h"
#include "ui/ErrorText.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cstdio>
#include <functional>

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

/// What is known of one volume: from its headers, and from its voxels where they could be read.
struct VolumeFacts {
    const core::SeriesEntry& entry;
    core::Result<core::LoadedVolume> loaded;

    [[nodiscard]] const core::VolumeGeometry& geometry() const
    {
        return loaded ? loaded->volume.geometry : entry.geometry;
    }
    [[nodiscard]] const std::vector<core::VolumeProblem>& listed() const
    {
        return loaded ? loaded->volume.problems : entry.problems;
    }
    [[nodiscard]] QStringList problems() const
    {
        QStringList texts;
        for (const core::VolumeProblem& problem : listed())
            texts.append(problem.text);
        if (!loaded)
            texts.append(ui::errorText(loaded.error()));
        return texts;
    }
};

QJsonObject json(const VolumeFacts& facts)
{
    const core::VolumeGeometry& geometry = facts.geometry();
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
        {QStringLiteral("problems"), QJsonArray::fromStringList(facts.problems())}};
    if (facts.loaded) {
        const core::Volume& volume = facts.loaded->volume;
        object.insert(QStringLiteral("min"), volume.minimum);
        object.insert(QStringLiteral("max"), volume.maximum);
        object.insert(QStringLiteral("voxelsSha256"), QString::fromLatin1(volume.voxelsSha256));
    }
    return object;
}

/// Loads volume after volume, one at a time in memory.
bool forEachVolume(const core::Study& study,
    const std::function<void(const core::StudyEntry&, const VolumeFacts&)>& visit)
{
    bool sound = true;
    for (const core::StudyEntry& one : study.listing().studies) {
        for (const core::SeriesEntry& entry : one.series) {
            const VolumeFacts facts{entry, study.load(entry.key)};
            sound = sound && facts.loaded.has_value();
            visit(one, facts);
        }
    }
    return sound;
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
        forEachVolume(source, [&](const core::StudyEntry& study, const VolumeFacts& facts) {
            if (&study != current)
                close();
            current = &study;
            series.append(json(facts));
        });
    close();
    const QJsonDocument document(QJsonObject{{QStringLiteral("studies"), studies}});
    std::fputs(document.toJson(QJsonDocument::Indented).constData(), stdout);
    return sound ? 0 : 1;
}

void printVolume(const VolumeFacts& facts)
{
    const core::StudyIdentity& identity = facts.entry.identity;
    const core::VolumeGeometry& geometry = facts.geometry();
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
                .arg(volume.minimum)
                .arg(volume.maximum)
                .arg(volume.unit));
    }
    for (const core::VolumeProblem& problem : facts.listed()) {
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
        forEachVolume(source, [&](const core::StudyEntry& study, const VolumeFacts& facts) {
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
    for (const core::ForeignObject& object : source.listing().foreign) {
        print(stdout,
            QStringLiteral("%1 × %2%3  %4")
                .arg(object.files.size())
                .arg(object.kind,
                    object.reason.isEmpty() ? QString()
                                            : QStringLiteral(" (%1)").arg(object.reason),
                    QFileInfo(object.files.front()).fileName()));
    }
    for (const core::UnreadableFile& file : source.listing().unreadable)
        print(stdout, QStringLiteral("not read: %1").arg(ui::errorText(file.error)));
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
