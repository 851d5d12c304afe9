// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/FollowBoundary.h"

#include "core/refine/deform/Deformation.h"
#include "core/refine/repair/CrossingGuard.h"
#include "core/refine/repair/MeshRestructuring.h"

#include <array>
#include <optional>

namespace core {

namespace {

constexpr int steps = 40;
constexpr int restructureEvery = 5;

std::vector<VertexId> yellowOf(const SimplexMesh& mesh)
{
    std::vector<VertexId> yellow = mesh.vertexIds();
    std::erase_if(yellow, [&mesh](VertexId id) { return mesh.mark(id) != SurfaceMark::Yellow; });
    return yellow;
}

} // namespace

Result<void> followBoundary(SimplexMeshEdit& edit, const BoundaryForce& boundary,
    const Progress& progress, const VolumeGeometry* apartOn)
{
    const SimplexMesh& mesh = edit.mesh();
    const std::array<const ExternalForce*, 1> forces{&boundary};
    const RestructuringSettings structure{.areaMm2 = meanFaceAreaMm2(mesh)};
    Deformation deformation({});
    deformation.activate(mesh, yellowOf(mesh));
    std::optional<CrossingGuard> guard;
    if (apartOn)
        guard.emplace(mesh, *apartOn);
    for (int step = 1; step <= steps && !deformation.active().empty(); ++step) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        if (guard)
            guard->moved(deformation.active());
        deformation.step(edit, forces);
        if (guard)
            deformation.stop(guard->keepApart(edit));
        // A vertex that moves wakes those beside it, whatever they are marked.
        std::vector<VertexId> others = deformation.active();
        std::erase_if(
            others, [&mesh](VertexId id) { return mesh.mark(id) == SurfaceMark::Yellow; });
        deformation.rest(others);
        if (step % restructureEvery != 0 || step == steps)
            continue;
        const Restructured done =
            restructure(edit, deformation.active(), structure, guard ? &*guard : nullptr);
        deformation.restructured(mesh, done.vertices);
    }
    return {};
}

} // namespace core
