// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

/// Have what is yellow follow the boundary of what the segment holds now. Red and green stay.
struct FollowMask { };

[[nodiscard]] Result<void> check(const FollowMask& edit, const Document& document);
Result<bool> apply(const FollowMask& edit, Document& document);
[[nodiscard]] EditEffects effects(const FollowMask& edit);
[[nodiscard]] RowTitle rowTitle(const FollowMask& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const FollowMask& edit, const ReachFacts& row);

} // namespace core
