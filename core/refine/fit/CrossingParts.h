// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/refine/mesh/SimplexMeshEdit.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

/// What became of the parts of a surface that pass through themselves or each other.
struct LaidAnew {
    std::size_t before = 0; ///< pairs of faces
    std::size_t left = 0; ///< pairs; if there are any, nothing was changed
    std::size_t parts = 0; ///< connected parts that were laid anew
};

/// Lays the connected parts of a surface anew that pass through themselves or each other: around
/// the voxels that they enclose together (SurfaceVoxels.h), with about as many vertices as they had
/// (MeasuredFit.h, kept apart). They are as many then, and of such genus, as their voxels tell. All
/// other parts stay as they are, with their ids, unless what was laid meets them: then they are
/// laid with it, as are all parts if one that is laid is a hollow.
///
/// Whole parts: a rim at which new and old faces are joined would have to be free of crossings
/// itself, and near them it rarely is. New vertices have the mark of an old one nearby, green ones
/// too: what is laid lies where the old surface encloses voxels, up to their size. A part that
/// encloses no voxel of the volume goes.
///
/// It takes as long as laying them. Errors: Cancelled; those of fillSurface(); InvalidField if
/// nothing would be left. Then nothing was changed.
[[nodiscard]] Result<LaidAnew> layCrossingsAnew(
    SimplexMeshEdit& edit, const VolumeGeometry& geometry, const Progress& progress);

} // namespace core
