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
// kept. The path of a surface tool is surfacePathOf() (SurfaceEdit.h).

/// What the pen reported of a stroke of drill or laser.
[[nodiscard]] std::vector<PenSample>* penSamplesOf(Edit& edit);
[[nodiscard]] const std::vector<PenSample>* penSamplesOf(const Edit& edit);

/// Whether such samples are evaluated by time (DrillPathSampler.h).
[[nodiscard]] bool* byTimeOf(Edit& edit);

/// The path of a brush that paints, carves or sets barriers.
[[nodiscard]] BrushPath* brushPathOf(Edit& edit);
[[nodiscard]] const BrushPath* brushPathOf(const Edit& edit);

/// The editable range of an edit of labels; null if this kind of edit has none.
[[nodiscard]] std::optional<EditableRange>* editableRangeOf(Edit& edit);
[[nodiscard]] const std::optional<EditableRange>* editableRangeOf(const Edit& edit);

// Criteria, leak guard and number of steps of a growth: of GrowSteps and ChangeInterval. A
// ResumeGrowth has them only after it was replaced by the growth that it continues
// (RecentGrowth.h).

[[nodiscard]] const GrowCriteria* growCriteriaOf(const Edit& edit);
[[nodiscard]] const GrowGuard* growGuardOf(const Edit& edit);
/// An optional without a value: the growth goes to closure.
[[nodiscard]] const std::optional<int>* growStepsOf(const Edit& edit);
[[nodiscard]] std::optional<int>* growStepsOf(Edit& edit);

} // namespace core
