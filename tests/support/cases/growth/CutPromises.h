// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"
#include "core/growth/GrowthCommands.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QString>

namespace test {

using Words = reference::DenseArray<std::uint32_t>;

/// What a cut of a growth promises (core/growth/cut/GrowthCut.h), looked up in the seed words
/// before and after it by means of this file alone: the sketch is gone; of other members none that
/// is nearer to the roots than to the sketch; no root ever; whoever has a way to a root has a
/// parent of an earlier generation. @return a sentence about the first promise that is broken, else
/// empty
[[nodiscard]] QString brokenPromise(
    const Words& before, const Words& after, const core::CutGrowth& command);

/// Those of plane 0, as they are now. Waits; results that were not collected are lost.
[[nodiscard]] Words seedWordsOf(core::EditEngine& engine, const glm::ivec3& size);
/// One brick of them.
void putBrick(Words& words, std::uint32_t brick, const std::vector<std::uint32_t>& held);

/// How many members of labels that may change the cut names, and how many of them are roots.
struct Sketched {
    int members = 0;
    int roots = 0;
};
[[nodiscard]] Sketched sketchedMembers(const Words& words, const core::CutGrowth& command);

/// A stroke that wanders over members from a random one on, as long as it is told; empty where
/// there are none.
[[nodiscard]] std::vector<glm::ivec3> strokeOverMembers(
    const Words& words, int length, Random& random);

} // namespace test
