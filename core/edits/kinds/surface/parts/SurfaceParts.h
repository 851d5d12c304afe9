// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/EditStatistics.h"
#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/answers/EditEffects.h"
#include "core/refine/mesh/SurfaceMark.h"
#include "core/titles/RowTitle.h"

namespace core {

struct SurfacePath;

// Parts that edits of the surface share.

/// Checks that there is a surface, and records whether it still agrees with its segment.
/// @param deforms it no longer agrees with its segment
Result<bool> changeSurface(Document& document, bool deforms);

/// Whether a path has as many pressures as points, if any. @param name of the edit
[[nodiscard]] Result<void> checkPressures(const SurfacePath& path, const char* name);

/// The effects of an edit that changes the surface and no voxel. One that stands open is a tool,
/// and its edit contains places.
[[nodiscard]] EditEffects surfaceEffects(Opening standsOpen);

/// "green"
[[nodiscard]] RowTitle markTitle(SurfaceMark mark);
/// The title followed by how much of the surface was changed.
[[nodiscard]] RowTitle strokeTitle(
    RowTitleCode code, const SurfacePath& path, const EditStatistics& statistics);

} // namespace core
