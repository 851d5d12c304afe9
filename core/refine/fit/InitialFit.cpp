// SPDX-License-Identifier: Apache-2.0
#include "core/refine/fit/InitialFit.h"

#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/deform/Deformation.h"
#include "core/refine/repair/CrossingGuard.h"
#include "core/refine/repair/MeshRestructuring.h"
#include "core/refine/repair/SelfIntersections.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace core {

namespace {

/// The last steps change no structure, and hold the surface to the boundary more than together.
constexpr int lastSteps = 10;
constexpr double lastInternal = 0.15;
/// The first surface lies off by less.
constexpr double reachVoxels = 4.0;

/// Parts of so few vertices say no more than which voxels they are around, which the first surface
/// does as well; forces would only crumple them.
constexpr std::size_t fewVertices = 64;

/// A mask as ragged as noise has more vertices than were asked for, since every hole is kept; it is
/// fitted less well then, rather than for minutes: so many vertices in all are moved, and looked at
/// for intersections.
constexpr std::size_t mostMoves = 8'000'000;
constexpr std::size_t mostLooks = 4'000'000;
constexpr int fewestSteps = lastSteps + 5;
constexpr int fewestRounds = 3;
constexpr int mostRounds = 40;
/// What may move before it is looked whether the surface passes through itself, in roots of a
/// face's area.
constexpr double movedUnseen = 0.15;

/// Those of parts that are large enough to be deformed.
std::vector<VertexId> verticesToFit(const SimplexMesh& mesh)
{
    std::vector<VertexId> vertices;
    std::vector<bool> seen(mesh.vertexSlots(), false);
    for (VertexId first = 0; first < mesh.vertexSlots(); ++first) {
        if (seen[first] || !mesh.hasVertex(first))
            continue;
        seen[first] = true;
        const std::size_t begin = vertices.size();
        vertices.push_back(first);
        for (std::size_t i = begin; i < vertices.size(); ++i) {
            for (const VertexId near : mesh.neighbours(vertices[i])) {
                if (!seen[near])
                    vertices.push_back(near);
                seen[near] = true;
            }
        }
        if (vertices.size() - begin < fewVertices)
            vertices.resize(begin);
    }
    return vertices;
}

} // namespace

Result<void> fitToMask(SimplexMesh& mesh, const BoxMask& mask, const VolumeGeometry& geometry,
    const InitialFitSettings& settings, const Progress& progress)
{
    if (mesh.vertexCount() == 0)
        return {};
    const glm::dvec3 spacing = geometry.spacingMm();
    const double widthMm = std::min({spacing.x, spacing.y, spacing.z});
    const BoundaryForce boundary(mask, geometry, reachVoxels);
    const std::vector<const ExternalForce*> forces{&boundary};
    DeformationSettings motion{.negligibleMm = 0.01 * widthMm, .stirringMm = 0.1 * widthMm};
    RestructuringSettings structure{.areaMm2 = meanFaceAreaMm2(mesh)};
    const std::size_t vertices = mesh.vertexCount();
    const int steps = std::min(settings.steps, std::max(fewestSteps, int(mostMoves / vertices)));
    const int rounds = std::clamp(int(mostLooks / vertices), fewestRounds, mostRounds);
    SimplexMeshEdit edit(mesh);
    Deformation deformation(motion);
    deformation.activate(mesh, verticesToFit(mesh));
    std::optional<CrossingGuard> guard;
    if (settings.keepsApart)
        guard.emplace(mesh, geometry);
    const auto keepApart = [&](double unseenMm) {
        if (guard && guard->movedMm() > unseenMm)
            deformation.stop(guard->keepApart(edit));
    };
    for (int i = 0; i < steps && !deformation.active().empty(); ++i) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        if (i == steps - lastSteps) {
            motion.internal = lastInternal;
            deformation = Deformation(motion);
            deformation.activate(mesh, verticesToFit(mesh));
        }
        if (guard)
            guard->moved(deformation.active());
        deformation.step(edit, forces);
        keepApart(movedUnseen * std::sqrt(structure.areaMm2));
        progress.report(ProgressStep::FittingSurface, i + 1, steps);
        if (settings.restructureEvery == 0 || i + 1 >= steps - lastSteps
            || (i + 1) % settings.restructureEvery != 0)
            continue;
        keepApart(0.0);
        const Restructured done =
            restructure(edit, deformation.active(), structure, guard ? &*guard : nullptr);
        deformation.restructured(mesh, done.vertices);
    }
    keepApart(0.0);
    if (settings.mendsCrossings)
        repairSelfIntersections(edit, geometry, rounds);
    edit.commit();
    return {};
}

Result<SimplexMesh> initialFit(const BoxMask& mask, const VolumeGeometry& geometry,
    const InitialFitSettings& settings, const Progress& progress)
{
    progress.report(ProgressStep::FittingSurface, 0, settings.steps);
    Result<SimplexMesh> mesh = refineSurfaceOf(mask, geometry, settings.vertices, progress);
    if (!mesh)
        return mesh;
    if (const Result<void> done = fitToMask(*mesh, mask, geometry, settings, progress); !done)
        return tl::unexpected(done.error());
    return mesh;
}

} // namespace core
