// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/criteria/ToleranceEdits.h"

#include "core/document/Document.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/GrowLimits.h"
#include "core/edits/kinds/criteria/GrowthParts.h"
#include "core/edits/kinds/parts/GrowthPlane.h"

#include <array>
#include <utility>

namespace core {

Result<ToleranceRule> toleranceRule(
    int segment, const GrowCriteria& criteria, const Document& document)
{
    const Segment* growing = document.segment(segment);
    if (!growing)
        return failure(ErrorCode::UnknownSegment, QString::number(segment));
    if (growing->locked)
        return failure(ErrorCode::SegmentLocked, growing->name);
    // A majority of one voxel of 27 and a passage of one voxel ask for nothing.
    const std::array<std::pair<const char*, bool>, 5> unknown{
        {{"sigmas", criteria.sigmas.has_value()}, {"difference", criteria.difference.has_value()},
            {"gradientDifference", criteria.gradientDifference.has_value()},
            {"majority", criteria.majority.value_or(0) > 1},
            {"passage",
                criteria.passage
                    && isAsked(passageOf(*criteria.passage, document.volumes.front().geometry))}}};
    for (const auto& [name, asked] : unknown) {
        if (asked)
            return failure(ErrorCode::InvalidField,
                QStringLiteral("tolerance.") + QLatin1String(name),
                Clause::saying("knows no least tolerance"));
    }
    if (criteria.smoothing.value_or(false))
        return failure(ErrorCode::InvalidField, QStringLiteral("tolerance.smoothing"),
            Clause::saying("must be off: tolerances are those of the voxels' own values"));
    GrowCriteria anyValue = criteria;
    anyValue.lower = anyValue.upper = 0.0;
    anyValue.plane = namedPlane(growing->plane);
    const Result<GrowBurst> burst = burstOf(anyValue, document, QStringLiteral("tolerance"));
    if (!burst)
        return tl::unexpected(burst.error());
    return ToleranceRule{.plane = growing->plane,
        .label = growing->label,
        .connectivity = burst->connectivity,
        .limits = burst->limits,
        .overwritable = burst->overwritable,
        .range = burst->range.value_or(GrowthRange())};
}

} // namespace core
