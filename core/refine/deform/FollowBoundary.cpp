// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/FollowBoundary.h"

#include "core/refine/deform/Deformation.h"
#include "core/refine/repair/MeshRestructuring.h"

#include <array>

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

void followBoundary(SimplexMeshEdit& edit, const BoundaryForce& boundary)
{
    const SimplexMesh& mesh = edit.mesh();
    const std::array<const ExternalForce*, 1> forces{&boundary};
    const RestructuringSettings structure{.areaMm2 = meanFaceAreaMm2(mesh)};
    Deformation deformation({});
    deformation.activate(mesh, yellowOf(mesh));
    for (int step = 1; step <= steps && !deformation.active().empty(); ++step) {
        deformation.step(edit, forces);
        // A vertex that moves wakes those beside it, whatever they are marked.
        std::vector<VertexId> others = deformation.active();
        std::erase_if(
            others, [&mesh](VertexId id) { return mesh.mark(id) == SurfaceMark::Yellow; });
        deformation.rest(others);
        if (step % restructureEvery != 0 || step == steps)
            continue;
        const Restructured done = restructure(edit, deformation.active(), structure);
        deformation.restructured(mesh, done.vertices);
    }
}

} // namespace core
