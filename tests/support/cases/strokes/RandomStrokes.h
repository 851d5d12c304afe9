// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/cases/RandomEdits.h"
#include "tests/support/cases/StrokeCases.h"

namespace test {

[[nodiscard]] core::Edit randomSeeds(const core::Document& document, int segment, Random& random);

/// Adds sessions that add, mute and delete, then single strokes; @p count of each.
void addRandomStrokes(std::vector<StrokeCase>& cases, int count);

} // namespace test
