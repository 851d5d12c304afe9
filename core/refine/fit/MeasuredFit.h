// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/refine/deform/RefineSurface.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/volume/VolumeGeometry.h"

#include <cstdint>
#include <optional>

namespace core {

/// A surface around a mask, with the difference between the voxels that it encloses
/// (SurfaceVoxels.h) and the mask.
struct MeasuredFit {
    SimplexMesh mesh;
    std::uint64_t voxels = 0; ///< of the mask
    std::uint64_t voxelsOff = 0; ///< in the mask but not enclosed, or the reverse
    /// Number of pairs of faces that pass through each other; counted only with keepsApart.
    std::size_t crossings = 0;
};

/// By which rules a surface is fitted; those of the first ones, unless others are named.
struct MeasuredFitRules {
    /// As in InitialFitSettings. If true, fewer vertices are tried first if none are given, and the
    /// surface may not pass through itself for the sake of voxels. If it does so nevertheless and
    /// cannot be repaired, all of it is laid again along the borders of its voxels, which never
    /// cross (borderSurfaceOf()), and crossings are prevented in each step from there on. So
    /// `crossings` is always 0 then.
    bool keepsApart = false;
    int mostVertices = mostVerticesOnce; ///< unless a number is given; at least leastVertices
};

/// The share of the mask's voxels that may differ.
constexpr double mostOffShare = 0.001;

/// Fits a surface (InitialFit.h), voxelises it and counts.
///
/// With @p vertices, the surface has about that many. Without, it has as many as are needed to
/// enclose the mask except for mostOffShare: first one vertex for each face between mask and
/// background, then, if that is not enough, two, which suffices to follow every voxel. The
/// structure of the latter is kept as it was laid, and where a voxel still differs, the vertices
/// around it are moved back to where they were laid. Chosen in this way, the number is between
/// leastVertices (RefineSurface.h) and that of the rules. If more would be needed, the result is
/// the best that was found, and the caller reports by how much it differs. Errors: those of
/// initialFit() and fillSurface().
[[nodiscard]] Result<MeasuredFit> measuredFit(const VoxelRuns& mask, const VolumeGeometry& geometry,
    std::optional<int> vertices, const Progress& progress, const MeasuredFitRules& rules = {});

} // namespace core
