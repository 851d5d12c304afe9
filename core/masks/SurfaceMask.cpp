// SPDX-License-Identifier: Apache-2.0
#include "core/masks/MaskParts.h"
#include "core/meshfile/MeshReader.h"
#include "core/refine/voxels/SurfaceFill.h"
#include "core/volume/WorldToIndex.h"

namespace core {

namespace {

LatticeSurface onLattice(ReadMeshPart& part, const QString& space, const WorldToIndex& toIndex)
{
    const glm::dvec3 turn = space == QLatin1String("RAS") ? glm::dvec3(-1, -1, 1) : glm::dvec3(1);
    LatticeSurface surface;
    surface.vertices.reserve(part.vertices.size());
    for (const glm::vec3& vertex : part.vertices)
        surface.vertices.push_back(latticePoint(toIndex(turn * glm::dvec3(vertex))));
    surface.triangles = std::move(part.triangles);
    return surface;
}

/// Enclosed, whichever way its triangles look.
double millilitresOf(const LatticeSurface& surface, const VolumeGeometry& geometry)
{
    double voxels = 0.0;
    constexpr double one = double(1 << LatticeSurface::bits);
    const glm::dvec3 middle(surface.vertices.front());
    for (const glm::uvec3& triangle : surface.triangles) {
        const auto corner = [&](int i) {
            return (glm::dvec3(surface.vertices[triangle[i]]) - middle) / one;
        };
        voxels += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0;
    }
    return std::abs(voxels) * geometry.voxelVolumeMm3() / 1000.0;
}

} // namespace

Result<MaskOnVolume> readSurfaceMask(
    const QString& path, const Volume& volume, const Progress& progress)
{
    Result<ReadMesh> mesh = readMesh(path);
    if (!mesh)
        return tl::unexpected(mesh.error());
    MaskOnVolume mask;
    if (mesh->space.isEmpty())
        mask.notes.push_back({.code = MaskNote::Code::UnnamedAxes});
    const WorldToIndex toIndex(volume.geometry);
    QStringList without;
    for (std::size_t i = 0; i < mesh->parts.size(); ++i) {
        ReadMeshPart& part = mesh->parts[i];
        QString name = part.name.simplified();
        if (name.isEmpty())
            name = mesh->parts.size() == 1 ? maskNameOf(path)
                                           : QStringLiteral("Surface %1").arg(i + 1);
        if (part.triangles.empty()) {
            without += name;
            continue;
        }
        const LatticeSurface surface = onLattice(part, mesh->space, toIndex);
        const SurfaceKind kind = kindOf(surface);
        if (kind == SurfaceKind::Open)
            return failure(ErrorCode::UnsupportedFormat, path,
                Clause::saying("the surface '%1' is not closed, so it has no inside", name));
        progress.report(ProgressStep::FillingSurfaces, int(i), int(mesh->parts.size()));
        Result<VoxelRuns> voxels = fillSurface(surface, kind, volume.geometry.size, progress);
        if (!voxels)
            return tl::unexpected(voxels.error());
        if (voxels->empty()) {
            without += name;
            continue;
        }
        if (kind == SurfaceKind::TwoFaced)
            mask.notes.push_back({.code = MaskNote::Code::TwoFaced, .names = {name}});
        else
            mask.notes.push_back({.code = MaskNote::Code::Enclosed,
                .names = {name},
                .fileMl = millilitresOf(surface, volume.geometry),
                .hereMl = millilitres(voxels->voxelCount(), volume.geometry)});
        mask.segments.push_back(
            {.name = name, .rgb = part.rgb, .code = {}, .voxels = *std::move(voxels)});
    }
    if (mask.segments.empty() && mesh->space.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("it surrounds no voxel of the study (its axes, which it does not name, "
                           "taken for LPS)"));
    if (!without.isEmpty() && !mask.segments.empty())
        mask.notes.push_back({.code = MaskNote::Code::NothingSurrounded, .names = without});
    return mask;
}

} // namespace core
