// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/ImportTargets.h"
#include "core/history/History.h"

#include <vector>

namespace core {

/// The imports of masks on the path to the present position, oldest first, with their voxels.
[[nodiscard]] std::vector<ImportMask> importsOf(const History& history);

/// The same, with the labels that each import gave. Labels identify segments even after they were
/// renamed, and are never given to another segment.
[[nodiscard]] std::vector<DoneImport> doneImports(const History& history);

} // namespace core
