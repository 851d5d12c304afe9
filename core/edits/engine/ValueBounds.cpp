// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/ValueBounds.h"

namespace core {

Result<CodeInterval> codesBetween(const QString& field, const std::optional<double>& lower,
    const std::optional<double>& upper, const VoxelEncoding& encoding)
{
    if (lower && upper && !(*lower <= *upper))
        return failure(ErrorCode::InvalidField, field + QStringLiteral(".upper"),
            QStringLiteral("%1 is below lower, %2").arg(*upper).arg(*lower));
    return CodeInterval{.low = lower ? encoding.lowestCodeAtLeast(*lower) : 0,
        .high = upper ? encoding.highestCodeAtMost(*upper) : VoxelEncoding::codeCount - 1};
}

} // namespace core
