// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/delta/BrickDelta.h"
#include "core/refine/mesh/SimplexMeshDelta.h"

#include <optional>

namespace core {

/// What a row changed of the surface. Its packed form (core/session/README.md) is stored in the
/// place where other rows have their voxels.
struct SurfaceStep {
    SimplexMeshDelta mesh;
    /// The mask that yellow parts follow; no voxels: there is no surface.
    struct Target {
        VoxelRuns voxels;
        /// the intended area of a face, constant while the surface exists
        double faceAreaMm2 = 0.0;
    };
    struct TargetChange {
        Target before;
        Target after;
    };
    std::optional<TargetChange> target{}; ///< none: it does not change
    QByteArray sha256Before; ///< of the mesh, hex; empty: there was no surface
    QByteArray sha256After;
};

[[nodiscard]] BrickDelta packed(const SurfaceStep& step);
/// @param voxels of the volume. Errors: SessionDamaged with the reason as first argument.
[[nodiscard]] Result<SurfaceStep> unpackedSurfaceStep(
    const BrickDelta& delta, std::uint64_t voxels);

} // namespace core
