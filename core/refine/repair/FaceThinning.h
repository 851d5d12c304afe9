// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/refine/mesh/SimplexMesh.h"

namespace core {

/// The mesh with the least of its faces merged into their neighbours, over and over, until it has
/// no more than @p vertices; what is left lies where it was, under new ids without gaps. Faces that
/// meet at an angle are not merged, nor any at a vertex that is green, nor into faces far above the
/// mean, so that there may be more.
/// Errors: Cancelled.
[[nodiscard]] Result<SimplexMesh> thinnedOut(
    SimplexMesh mesh, std::size_t vertices, const Progress& progress);

} // namespace core
