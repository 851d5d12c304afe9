// SPDX-License-Identifier: Apache-2.0
#include "app/commands/MeshCommand.h"

#include "app/steps/Arguments.h"
#include "app/steps/JsonLine.h"
#include "core/base/files/FileInUse.h"
#include "core/base/files/StagedFile.h"
#include "core/document/SegmentColours.h"
#include "core/masks/MaskOnVolume.h"
#include "core/measure/MeasuredSize.h"
#include "core/refine/fit/MeasuredFit.h"
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/mesh/SurfacePart.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/study/StudyLoader.h"
#include "ui/texts/MaskTexts.h"

#include <QFileInfo>

#include <array>
#include <cstdio>
#include <optional>

namespace app {

namespace {

using Writer = core::Result<void> (*)(
    const QString&, const std::vector<core::MeshPart>&, const QString&);

/// By how the file is called; null: not a format of surfaces.
Writer writerFor(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == QLatin1String("ply"))
        return core::writePly;
    if (ending == QLatin1String("stl"))
        return core::writeStl;
    if (ending == QLatin1String("obj"))
        return core::writeObj;
    return ending == QLatin1String("glb") ? core::writeGltf : nullptr;
}

/// What a surface is worth: how its voxels agree with the mask's.
struct Facts {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t parts = 0;
    std::size_t crossings = 0; ///< pairs of triangles that pass through each other
    std::uint64_t voxels = 0; ///< of the mask
    std::uint64_t meshVoxels = 0;
    std::uint64_t sharedVoxels = 0;
    std::optional<double> mm3{}; ///< none: nobody knows how large the voxels are
};

core::Result<Facts> factsOf(const core::SimplexMesh& mesh, const core::VoxelRuns& mask,
    const core::VolumeGeometry& geometry)
{
    const auto components = core::checkSimplexMesh(mesh);
    if (!components)
        return tl::unexpected(components.error());
    const core::Result<core::VoxelRuns> inside = core::voxelsOf(mesh, geometry, {});
    if (!inside)
        return tl::unexpected(inside.error());
    return Facts{.vertices = mesh.vertexCount(),
        .faces = mesh.faceCount(),
        .parts = components->size(),
        .crossings = core::selfIntersections(mesh, geometry).size(),
        .voxels = mask.voxelCount(),
        .meshVoxels = inside->voxelCount(),
        .sharedVoxels = core::sharedVoxels(*inside, mask)};
}

void print(const QString& segment, const Facts& facts, bool asJson)
{
    const double drift =
        100.0 * (double(facts.meshVoxels) - double(facts.voxels)) / double(facts.voxels);
    if (asJson) {
        printJsonLine({{QStringLiteral("segment"), segment},
            {QStringLiteral("vertices"), qint64(facts.vertices)},
            {QStringLiteral("faces"), qint64(facts.faces)},
            {QStringLiteral("parts"), qint64(facts.parts)},
            {QStringLiteral("crossings"), qint64(facts.crossings)},
            {QStringLiteral("voxels"), qint64(facts.voxels)},
            {QStringLiteral("meshVoxels"), qint64(facts.meshVoxels)},
            {QStringLiteral("sharedVoxels"), qint64(facts.sharedVoxels)},
            {QStringLiteral("volumeMm3"), facts.mm3 ? QJsonValue(*facts.mm3) : QJsonValue()}});
        return;
    }
    std::printf("%s\n", qUtf8Printable(segment));
    std::printf("  surface  %zu vertices, %zu faces, %zu part%s", facts.vertices, facts.faces,
        facts.parts, facts.parts == 1 ? "" : "s");
    if (facts.mm3)
        std::printf(", encloses %.3f mL", *facts.mm3 / 1000.0);
    std::printf("\n");
    std::printf("  voxels   %llu of the mask, %llu inside the surface (%+.2f %%), %llu shared\n",
        static_cast<unsigned long long>(facts.voxels),
        static_cast<unsigned long long>(facts.meshVoxels), drift,
        static_cast<unsigned long long>(facts.sharedVoxels));
    if (facts.crossings > 0)
        std::printf("  the surface passes through itself in %zu places\n", facts.crossings);
}

int runMesh(const Arguments& arguments)
{
    if (arguments.rest().size() != 1 || !arguments.has("study") || !arguments.has("out"))
        return reportUsageError("mesh", QStringLiteral("it needs a mask, --study and --out"));
    const QString maskPath = arguments.rest().front();
    const QString out = arguments.value("out");
    const Writer write = writerFor(out);
    if (!write)
        return reportUsageError(
            "mesh", QStringLiteral("--out must end with .ply, .stl, .obj or .glb"));
    constexpr int fewest = 100;
    constexpr int most = 400'000;
    bool isNumber = true;
    std::optional<int> vertices;
    if (arguments.has("vertices"))
        vertices = arguments.value("vertices").toInt(&isNumber);
    if (!isNumber || (vertices && (*vertices < fewest || *vertices > most)))
        return reportUsageError("mesh",
            QStringLiteral("--vertices must be a number from %1 to %2").arg(fewest).arg(most));
    const QString space = arguments.value("space").toUpper();
    if (arguments.has("space") && space != QLatin1String("LPS") && space != QLatin1String("RAS"))
        return reportUsageError("mesh", QStringLiteral("--space must be lps or ras"));
    if (const QString wrong = repairProblem(arguments); !wrong.isEmpty())
        return reportUsageError("mesh", wrong);
    const bool isRas = space == QLatin1String("RAS");

    const core::FileInUse mine(
        core::maskFilesIn(maskPath) + QStringList(maskPath), core::FileInUse::As::Mask);
    const core::FileInUse images({arguments.value("study")}, core::FileInUse::As::Study);
    // Known before minutes of work.
    if (const core::Result<void> fits = core::checkFileTarget(out, arguments.has("force")); !fits)
        return reportFailure(fits.error());

    const QString study = arguments.value("study");
    const auto loaded = core::loadVolume(study, seriesOf(arguments));
    if (!loaded)
        return reportFailure(loaded.error());
    reportProblems(loaded->volume, study);
    const auto mask = core::readMask(maskPath, loaded->volume, {});
    if (!mask)
        return reportFailure(mask.error());
    for (const core::MaskNote& note : mask->notes)
        std::fprintf(
            stderr, "%s: %s\n", qUtf8Printable(maskPath), qUtf8Printable(ui::maskNoteText(note)));

    const core::VolumeGeometry& geometry = loaded->volume.geometry;
    std::vector<core::MeshPart> parts;
    for (std::size_t i = 0; i < mask->segments.size(); ++i) {
        const core::MaskSegment& segment = mask->segments[i];
        if (arguments.has("segment") && segment.name != arguments.value("segment"))
            continue;
        // By the newest rules, as the window lays it: it never passes through itself.
        const auto fit = core::measuredFit(segment.voxels, geometry, vertices, {},
            {.keepsApart = true, .mostVertices = core::mostVertices});
        if (!fit)
            return reportFailure(fit.error());
        const core::SimplexMesh& mesh = fit->mesh;
        core::Result<Facts> facts = factsOf(mesh, segment.voxels, geometry);
        if (!facts)
            return reportFailure(facts.error());
        if (core::unknownSpacing(loaded->volume) == core::UnknownSpacing::Nothing)
            facts->mm3 = core::enclosedMm3(mesh);
        core::MeshPart part = core::partOf(mesh, isRas ? glm::dvec3(-1, -1, 1) : glm::dvec3(1));
        part.name = segment.name;
        part.rgb = segment.rgb.value_or(core::usualSegmentColour(i));
        part.label = std::uint8_t(std::min<std::size_t>(i + 1, 255));
        parts.push_back(std::move(part));
        print(segment.name, *facts, arguments.has("json"));
    }
    if (parts.empty())
        return reportFailure({.code = core::ErrorCode::UnsupportedFormat,
            .arguments = {maskPath,
                QStringLiteral("it has no segment '%1'").arg(arguments.value("segment"))}});
    core::Result<core::StagedFile> file = core::StagedFile::create(out, arguments.has("force"));
    if (!file)
        return reportFailure(file.error());
    if (const auto written =
            write(file->path(), parts, isRas ? QStringLiteral("RAS") : QStringLiteral("LPS"));
        !written) {
        core::Error error = written.error();
        error.arguments.replace(file->path(), out);
        return reportFailure(error);
    }
    if (const core::Result<void> kept = file->commit(); !kept)
        return reportFailure(kept.error());
    return 0;
}

} // namespace

const Command meshCommand{.name = "mesh",
    .words = "MASK",
    .usage = "MASK --study PATH --out FILE [--series UID] [--repair REPAIRS] [--segment NAME]"
             " [--vertices NUMBER] [--space lps|ras] [--json] [--force]",
    .summary = "writes the surface that refinement begins with, for each segment of a mask, as "
               "PLY, STL, OBJ or glTF (.glb), and tells how many of the mask's voxels it encloses; "
               "it has as many vertices as that takes, unless a number is asked for",
    .options =
        std::vector<Option>{{"study", "PATH", "the study, as a file or folder"},
            {"out", "FILE", "the file to write, as PLY, STL, OBJ or glTF (.glb) by its ending"},
            {"segment", "NAME", "which segment of the mask; all by default"},
            {"vertices", "NUMBER",
                "how many vertices the surface has; as many as it takes by default"},
            {"space", "lps|ras", "in which axes the surface is written"},
            {"json", nullptr, "prints a line of JSON for each result"},
            {"force", nullptr, "replaces a file that exists already"}}
        + seriesOptions(),
    .run = runMesh};

} // namespace app
