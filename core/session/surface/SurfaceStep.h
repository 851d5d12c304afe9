// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/delta/BrickDelta.h"
#include "core/refine/mesh/SimplexMeshDelta.h"

#include <optional>

namespace core {

/// What a row changed of the surface. Its packed form (README.md) stands where that of the voxels
/// stands in other rows.
struct SurfaceStep {
    SimplexMeshDelta mesh;
    /// What yellow parts follow; no voxels: there is no surface.
    struct Target {
        VoxelRuns voxels;
        double faceAreaMm2 = 0.0; ///< that a face is to have, as long as the surface lives
    };
    struct TargetChange {
        Target before;
        Target after;
    };
    std::optional<TargetChange> target{}; ///< none: it stays
    QByteArray sha256Before; ///< of the mesh, hex; empty: there was none
    QByteArray sha256After;
};

[[nodiscard]] BrickDelta packed(const SurfaceStep& step);
/// @param voxels of the volume. Errors: SessionDamaged with the reason as first argument.
[[nodiscard]] Result<SurfaceStep> unpackedSurfaceStep(
    const BrickDelta& delta, std::uint64_t voxels);

} // namespace core
