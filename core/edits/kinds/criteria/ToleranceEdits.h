// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/Tolerance.h"

namespace core {

struct Document;
struct GrowCriteria;

/// The rule of the tolerance field that shows how a segment would grow; the interval of the
/// criteria is not used. Errors: UnknownSegment, SegmentLocked, InvalidField (as for growBurst(),
/// or a criterion for which there is no least tolerance, or smoothing).
[[nodiscard]] Result<ToleranceRule> toleranceRule(
    int segment, const GrowCriteria& criteria, const Document& document);

} // namespace core
