// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

#include <optional>
#include <vector>

namespace core {

struct BrushPath;
struct EditableRange;
struct GrowCriteria;
struct GrowGuard;
struct PenSample;

// Parts that edits of several kinds have in common, found in any one edit; null: it has none. A
// kind has such a part when it holds a member of that name and type, so no list of kinds has to be
// kept. The way of a tool of the surface is surfacePathOf() (SurfaceEdit.h).

/// What the pen reported of a stroke of drill or laser.
[[nodiscard]] std::vector<PenSample>* penSamplesOf(Edit& edit);
[[nodiscard]] const std::vector<PenSample>* penSamplesOf(const Edit& edit);

/// Whether such samples are looked at by time (DrillPathSampler.h).
[[nodiscard]] bool* byTimeOf(Edit& edit);

/// The way of a brush that paints, carves or shuts voxels to growth.
[[nodiscard]] BrushPath* brushPathOf(Edit& edit);
[[nodiscard]] const BrushPath* brushPathOf(const Edit& edit);

/// The editable range of an edit of labels; null if this kind of edit has none.
[[nodiscard]] std::optional<EditableRange>* editableRangeOf(Edit& edit);
[[nodiscard]] const std::optional<EditableRange>* editableRangeOf(const Edit& edit);

// A growth says what it goes by and how far it goes: GrowSteps and ChangeInterval. One that goes on
// (ResumeGrowth) has these only when it is named (RecentGrowth.h).

[[nodiscard]] const GrowCriteria* growCriteriaOf(const Edit& edit);
[[nodiscard]] const GrowGuard* growGuardOf(const Edit& edit);
/// Where it points to nothing, the growth goes to closure.
[[nodiscard]] const std::optional<int>* growStepsOf(const Edit& edit);
[[nodiscard]] std::optional<int>* growStepsOf(Edit& edit);

} // namespace core
