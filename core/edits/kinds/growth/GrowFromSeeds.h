// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <optional>
#include <vector>

namespace core {

struct SpreadLabels;

/// Give every voxel of a box to the segment that is nearest along a path on which values change
/// little. Seeds are the voxels of segments and the sketched seeds.
struct GrowFromSeeds {
    /// labels that compete; none: all that are not locked
    std::optional<std::vector<int>> segments{};
    std::optional<GrowBox> box{}; ///< none: around the seeds with a margin of a twentieth
    int connectivity = 6; ///< 6, 18 or 26
    /// Modality units per millimetre of the path; none: a thousandth of the volume's range.
    std::optional<double> lengthCost{};
    bool overwriteUnlocked = false; ///< of segments that do not compete
    /// Which voxels may change at all; all others that are no seeds are walls.
    std::optional<EditableRange> editable{};
    /// The label plane that they lie in (GrowthPlane.h).
    std::optional<int> plane{};
};

[[nodiscard]] Result<void> check(const GrowFromSeeds& edit, const Document& document);
Result<bool> apply(const GrowFromSeeds& edit, Document& document);
[[nodiscard]] EditEffects effects(const GrowFromSeeds& edit);
[[nodiscard]] RowTitle rowTitle(const GrowFromSeeds& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const GrowFromSeeds& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const GrowFromSeeds& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(GrowFromSeeds& edit);

/// Errors: UnknownSegment, SegmentLocked, InvalidField (fewer than two segments, a box outside).
[[nodiscard]] Result<SpreadLabels> spreadLabels(
    const GrowFromSeeds& edit, const Document& document);

} // namespace core
