// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"

#include <optional>
#include <vector>

namespace core {

class DrillPathSampler;
struct BrushPath;
struct EngineEdit;
struct PenSample;

// What of an edit is told bit by bit while it stands open, wherever its kind keeps it. Whoever
// tells it needs no header of such a kind.

/// The samples of a stroke of drill or laser; null for other edits.
[[nodiscard]] std::vector<PenSample>* samplesOf(Edit& edit);
[[nodiscard]] const std::vector<PenSample>* samplesOf(const Edit& edit);

/// What makes the path of such samples, in a stroke that begins with this command; none for other
/// edits.
[[nodiscard]] std::optional<DrillPathSampler> samplerOf(const Edit& edit, const EngineEdit& begun);

/// Whether such samples are looked at by time (DrillPathSampler.h); null for other edits.
[[nodiscard]] bool* byTimeOf(Edit& edit);

/// The way of a brush that paints, carves or shuts to growth; null for other edits.
[[nodiscard]] BrushPath* brushPathOf(Edit& edit);
[[nodiscard]] const BrushPath* brushPathOf(const Edit& edit);

/// How many steps a growth is to go, or one under other limits; null for other edits.
[[nodiscard]] std::optional<int>* growthStepsOf(Edit& edit);
[[nodiscard]] const std::optional<int>* growthStepsOf(const Edit& edit);

} // namespace core
