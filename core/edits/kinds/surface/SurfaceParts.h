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

// What edits of the surface have in common.

/// Of what works on the surface: there has to be one. @param deforms the segment holds something
/// else from now on
Result<bool> changeSurface(Document& document, bool deforms);

/// Of what changes the surface, and no voxel. What stands open is a tool, which names places.
[[nodiscard]] EditEffects surfaceEffects(bool standsOpen);

/// "green"
[[nodiscard]] RowTitle markTitle(SurfaceMark mark);
/// "Sphere push 4.0 mm, 214 vertices"
[[nodiscard]] RowTitle strokeTitle(
    RowTitleCode code, const SurfacePath& path, const EditStatistics& statistics);

} // namespace core
