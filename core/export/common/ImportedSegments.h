// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/imports/ImportTargets.h"
#include "core/export/common/ExportMask.h"

namespace core {

/// The voxels that were imported into these segments. They are found by label, since names are not
/// unique, and a segment that was drawn may have the name of an imported one that was deleted. If a
/// segment was imported several times, the newest import counts; segments that were not imported
/// are left out. Cost ∝ the runs of the imported masks. Any thread.
/// @param imports in the order of the history, with their voxels
/// @param voxels number of voxels of the volume
[[nodiscard]] std::vector<ImportedVoxels> importedAs(const std::vector<Segment>& segments,
    const std::vector<DoneImport>& imports, std::uint64_t voxels);

} // namespace core
