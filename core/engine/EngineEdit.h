// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/TypeList.h"
#include "core/brick/BrickGrid.h"
#include "core/engine/GrowthExtensions.h"
#include "core/engine/LabelCommands.h"
#include "core/engine/LayerCommands.h"
#include "core/engine/StrokeExtensions.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/GrowthProgress.h"
#include "core/growth/SeedSpread.h"
#include "core/sculpt/DrillCut.h"
#include "core/sculpt/LaserCut.h"
#include "core/sculpt/OutlineCut.h"
#include "core/sculpt/ShellPeel.h"
#include "core/sculpt/labels/LabelOutlined.h"
#include "core/sculpt/labels/LabelScissors.h"
#include "core/sculpt/labels/LabelThreshold.h"
#include "core/sculpt/labels/LayerWrites.h"

#include <variant>

namespace core {

// The sums of all families of commands: any edit as engines receive it, and any extension of an
// open edit. Code that needs one particular command includes the header of its family instead.

/// Edits of growth (growth/GrowthCommands.h, growth/SeedSpread.h).
using GrowthEdits = TypeList<SeedPlacement, GrowBurst, ShrinkGrowth, CutGrowth, SpreadLabels>;
/// Edits under the pen.
/// - DrillCut, ShellPeel, OutlineCut (sculpt/DrillCut.h and so on) cut into the coverage of one
///   sculpt layer with a mask that is pressed into the volume along the view, LaserCut along the
///   normals of the surface.
/// - CapsuleCut, PaintLabel and PaintBarrier work with a brush.
using StrokeEdits =
    TypeList<DrillCut, LaserCut, ShellPeel, OutlineCut, CapsuleCut, PaintLabel, PaintBarrier>;
/// Edits of whole labels and layers, of listed voxels, by values (sculpt/labels/LabelThreshold.h),
/// and of what lies under a curve (sculpt/labels/LabelScissors.h). CoverLabel, FoldLayer,
/// MapLabels and MapPlanes are in sculpt/labels/LayerWrites.h, and so is LabelWrites, a list of
/// edits that give labels to voxels (LabelOutlined.h belongs to it, too).
using WholeEdits = TypeList<EraseLabel, CoverLabel, FoldLayer, BarrierListed, LabelThreshold,
    LabelScissors, MapLabels, MapPlanes>;

using EngineEditVariant =
    JoinedTypes<GrowthEdits, StrokeEdits, WholeEdits, LabelWrites>::List::Variant;

/// Any one of these edits. As with Edit (core/edits/kinds/Edit.h), copying is compiled only once.
struct EngineEdit : EngineEditVariant {
    using EngineEditVariant::variant;
    EngineEdit();
    EngineEdit(const EngineEdit& other);
    EngineEdit(EngineEdit&& other) noexcept;
    EngineEdit& operator=(const EngineEdit& other);
    EngineEdit& operator=(EngineEdit&& other) noexcept;
    ~EngineEdit();
};

/// Checks whether an edit may begin in a volume of this grid. Errors: InvalidField.
[[nodiscard]] Result<void> checkEdit(const EngineEdit& edit, const BrickGrid& grid);

/// Whether an engine may work on it for long after it has begun, because it goes through much of
/// the volume. While it does, the edit can be given up (EditEngine::giveUp()).
[[nodiscard]] bool mayTakeLong(const EngineEdit& edit);

/// The extensions that an open edit takes.
using EngineExtensionVariant = std::variant<DrillPath, GrowAdvance, GrowPause, CapsulePath,
    PeelDepth, ShrinkTo, GrowAnew, ForgetSpread, CutFurther>;

/// Any one of them. It is a struct so that headers can declare it without including the commands.
struct EngineExtension : EngineExtensionVariant {
    using EngineExtensionVariant::variant;
};

} // namespace core
