// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sculpt/labels/NudgeStart.h"

#include <cstdint>
#include <vector>

namespace core {

struct BrushPath;
struct VolumeGeometry;

/// The disc of a nudge at its first point, in an engine's integers, and which bricks must be read
/// to find out how far the segment's border is from there (NudgeStart.h).
struct NudgeDisc {
    CapsuleFrame frame{};
    glm::ivec3 centre{0}; ///< in stroke coordinates (CapsuleSweep.h), mm16
    /// Numbers of the bricks whose labels must be read, ascending; empty if the disc begins so far
    /// from the volume that no voxel is near it.
    std::vector<std::uint32_t> bricks{};
};

/// @param path a disc and at least its first point, already rounded as edits are (EditQuantise.h),
/// so that the stroke begins exactly where this result says
/// Errors: InvalidField below @p name (no point, no normal, a shape other than a disc).
[[nodiscard]] Result<NudgeDisc> nudgeDisc(
    const BrushPath& path, const VolumeGeometry& geometry, const QString& name);

/// NudgeStart::fittingRadius in millimetres, for the edit.
[[nodiscard]] double fittingRadiusMm(const NudgeStart& start);

} // namespace core
