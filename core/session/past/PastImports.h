// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/imports/ImportTargets.h"
#include "core/history/History.h"

#include <vector>

namespace core {

/// The rows of the imports of masks on the path to the present position, oldest first.
[[nodiscard]] std::vector<RowId> importRows(const History& history);

/// These imports, with their voxels and the labels that each of them gave. Labels identify segments
/// even after they were renamed, and are never given to another segment.
[[nodiscard]] std::vector<DoneImport> doneImports(const History& history);

} // namespace core
