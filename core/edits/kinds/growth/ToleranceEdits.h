// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/Tolerance.h"

namespace core {

struct Document;
struct GrowCriteria;

/// By which a tolerance field shows how a segment would grow; of the criteria the interval is not
/// looked at. Errors: UnknownSegment, SegmentLocked, InvalidField (as of growBurst(),
/// or a criterion that knows no least tolerance).
[[nodiscard]] Result<ToleranceRule> toleranceRule(
    int segment, const GrowCriteria& criteria, const Document& document);

} // namespace core
