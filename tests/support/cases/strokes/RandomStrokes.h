// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/StrokeCases.h"

namespace test {

[[nodiscard]] core::Edit randomSeeds(const core::Document& document, int segment, Random& random);

/// Sessions that add, mute and delete, then strokes one after the other; so many of each.
void addRandomStrokes(std::vector<StrokeCase>& cases, int count);

} // namespace test
