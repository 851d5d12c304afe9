// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"

namespace core {

/// Checks that a segment lies in label plane 0. Protection from sculpting looks for segments only
/// there; every edit that needs it refuses other segments by this function.
/// @param field name of the field that names the segment, such as "changeSegment.protected"
/// @param what what the segment cannot do elsewhere, such as "be spared by a cut"
/// Errors: InvalidField.
[[nodiscard]] inline Result<void> checkInFirstPlane(
    const QString& field, const Segment& segment, const Clause& what)
{
    if (segment.plane == 0)
        return {};
    return failure(ErrorCode::InvalidField, field,
        Clause::saying("'%1' overlaps other segments of its file, so it lies on label plane %2; "
                       "segments there cannot %3 yet",
            segment.name, int(segment.plane) + 1, what));
}

} // namespace core
