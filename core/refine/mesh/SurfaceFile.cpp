// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceFile.h"

#include "core/base/files/StagedFile.h"
#include "core/refine/mesh/SurfacePart.h"

#include <QFileInfo>

#include <algorithm>
#include <array>

namespace core {

namespace {

using MeshWriter = Result<void> (*)(const QString&, const std::vector<MeshPart>&, const QString&);
constexpr std::array<MeshWriter, 4> writers{writeStl, writePly, writeObj, writeGltf};

} // namespace

const std::vector<QString>& surfaceFileEndings()
{
    static const std::vector<QString> endings{
        QStringLiteral("stl"), QStringLiteral("ply"), QStringLiteral("obj"), QStringLiteral("glb")};
    return endings;
}

Result<void> writeSurfaceFile(
    const SimplexMesh& mesh, const SurfaceFileFacts& facts, const QString& path, bool replaces)
{
    const auto& endings = surfaceFileEndings();
    const auto known =
        std::find(endings.begin(), endings.end(), QFileInfo(path).suffix().toLower());
    if (known == endings.end())
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("a surface is written as .stl, .ply, .obj or .glb"));
    Result<StagedFile> file = StagedFile::create(path, replaces);
    if (!file)
        return tl::unexpected(file.error());
    MeshPart part = partOf(mesh);
    part.name = facts.name;
    part.rgb = facts.rgb;
    part.label = facts.label;
    const MeshWriter write = writers[std::size_t(known - endings.begin())];
    if (const Result<void> written = write(file->path(), {part}, QStringLiteral("LPS")); !written) {
        Error error = written.error();
        error.arguments.replace(file->path(), path);
        return tl::unexpected(error);
    }
    return file->commit();
}

} // namespace core
