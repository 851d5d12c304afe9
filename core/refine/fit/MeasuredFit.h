// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/volume/VolumeGeometry.h"

#include <cstdint>
#include <optional>

namespace core {

/// A surface around a mask, and how well it does: what it encloses (SurfaceVoxels.h) against the
/// mask.
struct MeasuredFit {
    SimplexMesh mesh;
    std::uint64_t voxels = 0; ///< of the mask
    std::uint64_t voxelsOff = 0; ///< in the mask and not enclosed, or the other way round
};

/// Of the mask's voxels, so many may be off.
constexpr double mostOffShare = 0.001;

/// Fits a surface (InitialFit.h), voxelises it and counts.
///
/// With a number of vertices, one of about so many. Without, one of as many as the mask takes to be
/// enclosed but for mostOffShare: first a vertex for each face between mask and background; where
/// that does not do, two, which is enough to follow every voxel. Of these the structure stays as it
/// was laid, and where a voxel is off all the same, the vertices around go back to where they were
/// laid. No surface gets more than mostVertices (RefineSurface.h) that way, or is asked for fewer
/// than leastVertices. What would need more is the best that was found: whoever asks for it tells
/// by how much it is off.
/// Errors: those of initialFit() and fillSurface().
[[nodiscard]] Result<MeasuredFit> measuredFit(const VoxelRuns& mask, const VolumeGeometry& geometry,
    std::optional<int> vertices, const Progress& progress);

} // namespace core
