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
    /// A tool whose strokes people tell from those of a brush.
    enum class Tool {
        /// A disc that pushes the border of the segment in one slice: outwards, or inwards with
        /// `erase`. Where it may begin is a matter of the tool (sculpt/labels/NudgeStart.h); what
        /// it changes is what a brush would change.
        Nudge,
    };
    int segment = 0; ///< label
    BrushPath path{};
    bool erase = false;
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    bool overwriteUnlocked = false;
    bool seeds = false; ///< growth may continue from what is painted
    /// It follows edges: of what is under the brush only voxels whose values differ from the one
    /// where the stroke begins by at most this, and that are joined to where the pen was
    /// (EdgeRegion.h). Modality units, at least 0; none: all that is under the brush.
    std::optional<double> edgeTolerance{};
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
    std::optional<Tool> tool{}; ///< it decides no voxel; none: a brush
    /// With edgeTolerance: the pressures of the path are shares of that, and the radius is whole.
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
/// What an engine is told of the path. Expects a stroke that paintLabel() accepts.
[[nodiscard]] CapsulePath paintPath(const PaintStroke& stroke, const VolumeGeometry& geometry);

} // namespace core
