// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"
#include "core/growth/GrowthCommands.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QString>

namespace test {

using Words = reference::DenseArray<std::uint32_t>;

/// Checks the guarantees of a cut of a growth (core/growth/cut/GrowthCut.h) on the seed words
/// before and after it, using only code of this file: the sketch is removed; no other member that
/// is nearer to the roots than to the sketch is removed; no root is removed; every member that can
/// reach a root has a parent of an earlier generation.
/// @return a sentence about the first guarantee that is broken, else empty
[[nodiscard]] QString brokenPromise(
    const Words& before, const Words& after, const core::CutGrowth& command);

/// The present seed words of plane 0. Waits; results that were not collected are lost.
[[nodiscard]] Words seedWordsOf(core::EditEngine& engine, const glm::ivec3& size);
/// Writes one brick of seed words.
void putBrick(Words& words, std::uint32_t brick, const std::vector<std::uint32_t>& held);

/// How many members of changeable labels the cut names, and how many of them are roots.
struct Sketched {
    int members = 0;
    int roots = 0;
};
[[nodiscard]] Sketched sketchedMembers(const Words& words, const core::CutGrowth& command);

/// A random walk over members, at most @p length long; empty if there are no members.
[[nodiscard]] std::vector<glm::ivec3> strokeOverMembers(
    const Words& words, int length, Random& random);

} // namespace test
