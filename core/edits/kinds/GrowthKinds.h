// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/EditKinds.h"

namespace core {

/// The kinds of edits that a growth consists of: its seeds and barriers, its steps, and what takes
/// some of them back. What is said and drawn of rows of growth is asked by overloads for all of
/// them, so that a kind that is added does not compile until it answers.
using GrowthKinds = EditKinds<SeedStroke, BarrierStroke, GrowSteps, ResumeGrowth, ChangeInterval,
    ShrinkSteps, ShrinkAt, PlugLeak, GrowFromSeeds>;
template <class E>
concept isGrowthKind = (placeAmong<E>(GrowthKinds()) < GrowthKinds::count);

} // namespace core
