// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"

namespace core {

/// Checks that a segment lies in label plane 0. Growth, barriers and protection from sculpting look
/// for segments only there; every edit that needs them refuses other segments by this function.
/// @param field name of the field that names the segment, such as "seed.segment"
/// @param what what the segment cannot do elsewhere, such as "grow"
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
