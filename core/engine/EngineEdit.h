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

// Any edit as engines see them, and what one that is open can be told: the sum of all families.
// Who needs one of them includes its own header.

/// Of growth: growth/GrowthCommands.h, growth/SeedSpread.h.
using GrowthEdits = TypeList<SeedPlacement, GrowBurst, ShrinkGrowth, CutGrowth, SpreadLabels>;
/// Under the pen. DrillCut, ShellPeel, OutlineCut (sculpt/DrillCut.h and so on): cut into the
/// coverage of one sculpt layer with a mask that is pressed into the volume along the view;
/// LaserCut: along the surface's normals. CapsuleCut, PaintLabel, PaintBarrier: with a brush.
using StrokeEdits =
    TypeList<DrillCut, LaserCut, ShellPeel, OutlineCut, CapsuleCut, PaintLabel, PaintBarrier>;
/// Of whole labels and layers, of places that are listed, of values
/// (sculpt/labels/LabelThreshold.h), and of what lies under a curve
/// (sculpt/labels/LabelScissors.h). CoverLabel, FoldLayer: sculpt/labels/LayerWrites.h, as
/// LabelWrites, which give labels to voxels (and LabelOutlined.h).
using WholeEdits =
    TypeList<EraseLabel, CoverLabel, FoldLayer, BarrierListed, LabelThreshold, LabelScissors>;

using EngineEditVariant =
    JoinedTypes<GrowthEdits, StrokeEdits, WholeEdits, LabelWrites>::List::Variant;

/// Any one of them; like Edit (core/edits/kinds/Edit.h), its copies are compiled once.
struct EngineEdit : EngineEditVariant {
    using EngineEditVariant::variant;
    EngineEdit();
    EngineEdit(const EngineEdit& other);
    EngineEdit(EngineEdit&& other) noexcept;
    EngineEdit& operator=(const EngineEdit& other);
    EngineEdit& operator=(EngineEdit&& other) noexcept;
    ~EngineEdit();
};

/// Whether an edit could begin in a volume. Errors: InvalidField.
[[nodiscard]] Result<void> checkEdit(const EngineEdit& edit, const BrickGrid& grid);

/// What an open edit can be told while it runs.
using EngineExtensionVariant = std::variant<DrillPath, GrowAdvance, GrowPause, CapsulePath,
    PeelDepth, ShrinkTo, GrowAnew, ForgetSpread, CutFurther>;

/// Any one of them; a struct, so that headers can name it without knowing them.
struct EngineExtension : EngineExtensionVariant {
    using EngineExtensionVariant::variant;
};

} // namespace core
