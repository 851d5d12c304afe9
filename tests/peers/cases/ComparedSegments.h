// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <optional>

namespace peer {

class RealSegment;
struct WholeSegment;

/// An operation that was done both ways.
struct Compared {
    std::int64_t voxels = 0; ///< of the volume, all of which were compared
    std::int64_t changed = 0; ///< by the operation
    std::int64_t either = 0; ///< where either side is right
    std::int64_t differing = 0;
    std::int64_t unexplained = 0; ///< of these: where either side may not be right
    /// The labels at hand, until what changes is worked out, on all cores; none for edits that the
    /// engine carries out.
    std::optional<double> workedOutMilliseconds;
    /// The whole step: labels read, worked out, written and kept in the history.
    double stepMilliseconds = 0.0;
    double theirMilliseconds = 0.0;
};
/// Does it both ways, and takes it back. Errors: those of the edit.
[[nodiscard]] core::Result<Compared> compare(RealSegment& segment, const WholeSegment& operation);

} // namespace peer
