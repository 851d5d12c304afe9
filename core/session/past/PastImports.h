// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/ImportTargets.h"
#include "core/history/History.h"

#include <vector>

namespace core {

/// The imports of masks among the steps that led to the present state, oldest first, with their
/// voxels.
[[nodiscard]] std::vector<ImportMask> importsOf(const History& history);

/// The same with the labels that they gave, which stay when a segment gets another name, and which
/// no other segment gets.
[[nodiscard]] std::vector<DoneImport> doneImports(const History& history);

} // namespace core
