// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <optional>

namespace core {

struct CapsulePath;
struct PaintLabel;
struct VolumeGeometry;

/// Paint a segment along a path, or erase it.
struct PaintStroke {
    /// A tool whose strokes are named differently from those of a brush.
    enum class Tool {
        /// A disc that pushes the border of the segment in one slice: outwards, or inwards with
        /// `erase`. The tool decides where it may begin (sculpt/labels/NudgeStart.h); it changes
        /// the same voxels as a brush would.
        Nudge,
    };
    int segment = 0; ///< label
    BrushPath path{};
    bool erase = false;
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    bool overwriteUnlocked = false;
    bool seeds = false; ///< growth may continue from what is painted
    /// Makes the brush follow edges: of the voxels under the brush, it changes only those whose
    /// values differ by at most this from the value where the stroke begins, and that are connected
    /// with where the pen was (EdgeRegion.h). Modality units, at least 0; none: all voxels under
    /// the brush.
    std::optional<double> edgeTolerance{};
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
    /// Only for the name of the row, it decides no voxel; none: a brush.
    std::optional<Tool> tool{};
    /// With edgeTolerance: the pressures of the path change that tolerance instead of the radius.
    std::optional<bool> toleranceByPressure{};
};

[[nodiscard]] Result<void> check(const PaintStroke& edit, const Document& document);
Result<bool> apply(const PaintStroke& edit, Document& document);
[[nodiscard]] EditEffects effects(const PaintStroke& edit);
[[nodiscard]] RowTitle rowTitle(const PaintStroke& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const PaintStroke& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const PaintStroke& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(PaintStroke& edit);

/// The command without the path. Errors: UnknownSegment, SegmentLocked, InvalidField.
[[nodiscard]] Result<PaintLabel> paintLabel(const PaintStroke& stroke, const Document& document);
/// The path as an engine receives it.
/// @pre paintLabel() accepts the stroke
[[nodiscard]] CapsulePath paintPath(const PaintStroke& stroke, const VolumeGeometry& geometry);

} // namespace core
