// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "tests/peers/cases/PeerMask.h"
#include "tests/peers/cases/RealSegment.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace peer {

/// An operation on a whole segment, as the edit of a user and as filters of ITK.
struct WholeSegment {
    const char* name;
    const char* peer; ///< the filters
    RealSegment::State before;
    std::function<core::Edit(const RealSegment&)> edit;
    std::function<PeerMask(const RealSegment&)> theirs;
    /// Why some voxels may differ; null: none may.
    const char* whyEither = nullptr;
    /// What is done first, after which segment 1 is still as it was.
    std::function<std::vector<core::Edit>(const RealSegment&)> first{};
    std::uint8_t plane = 0; ///< the label plane that is compared
};
/// Every operation that ITK has filters for.
[[nodiscard]] const std::vector<WholeSegment>& wholeSegments();

} // namespace peer
