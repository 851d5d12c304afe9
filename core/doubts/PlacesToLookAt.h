// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/doubts/DoubtfulPlace.h"
#include "core/doubts/FaintBorder.h"

namespace core {

/// Where to look first in a segment that may have errors, a network's mask for instance: where its
/// border follows no edge of the image, and where it disagrees with a second mask. Nothing is
/// changed; the same is found on every machine.
///
/// Both kinds take turns, disagreements first: of these the largest, of places without an edge the
/// most doubtful. A place without an edge beside a disagreement that is listed is the same place,
/// and not listed again.
/// Cost: that of FaintBorder and onlyIn(). Any thread. Errors: Cancelled.
/// @param second null: there is none
/// @param most the greatest number of places
[[nodiscard]] Result<std::vector<DoubtfulPlace>> placesToLookAt(const BorderSource& source,
    const VoxelRuns* second, std::size_t most, const Progress& progress);

} // namespace core
