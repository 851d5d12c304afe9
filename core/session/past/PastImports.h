// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/ImportMask.h"
#include "core/history/History.h"

#include <vector>

namespace core {

/// The imports of masks among the steps that led to the present state, oldest first, with their
/// voxels.
[[nodiscard]] std::vector<ImportMask> importsOf(const History& history);

} // namespace core
