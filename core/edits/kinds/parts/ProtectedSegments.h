// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

namespace core {

/// Segments that a cut leaves uncut, by label, ascending, with the voxels that they had when it was
/// made. Carrying out a cut adds those that are protected (core/edits/engine/SegmentProtection.h),
/// so that the edit contains what it reads. A cut that restores has none.
using ProtectedSegments = std::optional<std::vector<int>>;

} // namespace core
