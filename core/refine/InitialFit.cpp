// SPDX-License-Identifier: Apache-2.0
#include "core/refine/InitialFit.h"

#include "core/refine/BoundaryForce.h"
#include "core/refine/Deformation.h"
#include "core/refine/MeshRestructuring.h"
#include "core/refine/SelfIntersections.h"

#include <algorithm>

namespace core {

namespace {

/// The last steps change no structure, and hold the surface to the boundary more than together.
constexpr int lastSteps = 10;
constexpr double lastInternal = 0.15;
/// The first surface lies off by less.
constexpr double reachVoxels = 4.0;

} // namespace

Result<SimplexMesh> initialFit(const BoxMask& mask, const VolumeGeometry& geometry,
    const InitialFitSettings& settings, const Progress& progress)
{
    const QString step = QStringLiteral("Fitting the surface");
    progress.report(step, 0, settings.steps);
    Result<SimplexMesh> mesh = refineSurfaceOf(mask, geometry, settings.vertices, progress);
    if (!mesh || mesh->vertexCount() == 0)
        return mesh;
    const glm::dvec3 spacing = geometry.spacingMm();
    const double widthMm = std::min({spacing.x, spacing.y, spacing.z});
    const BoundaryForce boundary(mask, geometry, reachVoxels);
    const std::vector<const ExternalForce*> forces{&boundary};
    DeformationSettings motion{.negligibleMm = 0.01 * widthMm, .stirringMm = 0.1 * widthMm};
    RestructuringSettings structure{.areaMm2 = meanFaceAreaMm2(*mesh)};
    SimplexMeshEdit edit(*mesh);
    Deformation deformation(motion);
    deformation.activateAll(*mesh);
    for (int i = 0; i < settings.steps && !deformation.active().empty(); ++i) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        if (i == settings.steps - lastSteps) {
            motion.internal = lastInternal;
            deformation = Deformation(motion);
            deformation.activateAll(*mesh);
        }
        deformation.step(edit, forces);
        progress.report(step, i + 1, settings.steps);
        if (settings.restructureEvery == 0 || i + 1 >= settings.steps - lastSteps
            || (i + 1) % settings.restructureEvery != 0)
            continue;
        const Restructured done = restructure(edit, deformation.active(), structure);
        deformation.restructured(*mesh, done.vertices);
    }
    repairSelfIntersections(edit, geometry);
    edit.commit();
    return mesh;
}

} // namespace core
