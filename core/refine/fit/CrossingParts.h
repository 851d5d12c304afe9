// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/refine/mesh/SimplexMeshEdit.h"
#include "core/volume/VolumeGeometry.h"

namespace core {

/// The result of layCrossingsAnew().
struct LaidAnew {
    std::size_t before = 0; ///< pairs of faces that passed through each other before
    /// Pairs that could not be avoided; if there are any, nothing was changed.
    std::size_t left = 0;
    std::size_t parts = 0; ///< connected parts that were replaced
};

/// Replaces the connected parts of a surface that pass through themselves or each other. New parts
/// are laid around the voxels that the old ones enclose together (SurfaceVoxels.h), with about as
/// many vertices (MeasuredFit.h, kept apart). Their number and genus follow from these voxels. All
/// other parts stay as they are, with their ids. But if a new part meets one of these, that one is
/// replaced, too, and if one that is replaced bounds a hollow, all are.
///
/// Whole parts are replaced because the rim at which new and old faces would be joined would have
/// to be free of crossings itself, and near crossings it rarely is. Each new vertex gets the mark
/// of an old one nearby, even if that is green (approved): the new surface lies where the old one
/// encloses voxels, to within their size. A part that encloses no voxel of the volume disappears.
///
/// It takes as long as laying such a surface. Errors: Cancelled; those of fillSurface();
/// InvalidField if nothing would be left. After an error nothing was changed.
[[nodiscard]] Result<LaidAnew> layCrossingsAnew(
    SimplexMeshEdit& edit, const VolumeGeometry& geometry, const Progress& progress);

} // namespace core
