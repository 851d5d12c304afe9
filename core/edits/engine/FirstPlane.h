// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"

namespace core {

/// Whether a segment lies in plane 0, where growth, barriers and protection from sculpting look for
/// segments: the one place that refuses them to segments of further planes.
/// @param field that names it, such as "seed.segment"
/// @param what it cannot do elsewhere, such as "grow"
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
