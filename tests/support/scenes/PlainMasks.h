// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/Edit.h"

#include <QString>

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace test {

/// What a mask says of one segment.
struct MaskPart {
    QString name;
    core::VoxelRuns voxels; ///< x fastest
    std::uint32_t rgb = 7;
};

/// The import of a mask, as if it had been read from a file: segments that many tests begin with,
/// which need not include the header of that edit.
/// @param planes the label plane of each part; none: all lie in the first
[[nodiscard]] core::Edit maskImport(const QString& file, const glm::ivec3& size,
    const std::vector<MaskPart>& parts, const std::vector<int>& planes = {});
/// The same of "matter.nii", with "Matter 1", "Matter 2" …
[[nodiscard]] core::Edit matterImport(
    const glm::ivec3& size, std::span<const core::VoxelRuns> segments);

} // namespace test
