// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/EditKinds.h"

namespace core {

/// The kinds of edits that a growth consists of: its seeds and barriers, its steps, and what takes
/// some of them back. Code that words or draws rows of growth has an overload for each of them, so
/// that a new kind does not compile until it is handled.
using GrowthKinds = EditKinds<SeedStroke, BarrierStroke, GrowSteps, ResumeGrowth, ChangeInterval,
    ShrinkSteps, ShrinkAt, PlugLeak, GrowFromSeeds>;
template <class E>
concept isGrowthKind = (placeAmong<E>(GrowthKinds()) < GrowthKinds::count);

} // namespace core
