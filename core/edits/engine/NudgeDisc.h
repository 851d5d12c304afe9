// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sculpt/labels/NudgeStart.h"

#include <cstdint>
#include <vector>

namespace core {

struct BrushPath;
struct VolumeGeometry;

/// The disc of a nudge where it begins, in an engine's integers, and what has to be read to know
/// where the border is from there.
struct NudgeDisc {
    CapsuleFrame frame{};
    glm::ivec3 centre{0}; ///< stroke coordinates
    /// Of the labels, ascending; none: it begins so far from the volume that nothing is near it.
    std::vector<std::uint32_t> bricks{};
};

/// @param path a disc with its first point, rounded as edits are (EditQuantise.h), so that the
/// stroke begins where this says
/// Errors: InvalidField below @p name (no point, no normal, another shape).
[[nodiscard]] Result<NudgeDisc> nudgeDisc(
    const BrushPath& path, const VolumeGeometry& geometry, const QString& name);

/// The radius that fits, for the edit.
[[nodiscard]] double fittingRadiusMm(const NudgeStart& start);

} // namespace core
