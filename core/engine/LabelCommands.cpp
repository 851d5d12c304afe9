// SPDX-License-Identifier: Apache-2.0
#include "core/engine/LabelCommands.h"

namespace core {

Result<void> checkSound(const EraseLabel& edit, const BrickGrid&)
{
    if (edit.label == 0)
        return failure(
            ErrorCode::InvalidField, QStringLiteral("label"), Clause::saying("0 is no segment"));
    return {};
}

Result<void> checkSound(const PaintLabel& edit, const BrickGrid& grid)
{
    if (edit.label == 0)
        return failure(
            ErrorCode::InvalidField, QStringLiteral("label"), Clause::saying("0 is no segment"));
    if (!isSound(edit.frame))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("frame"), Clause::saying("is not sound"));
    if (edit.edges && !isSound(*edit.edges, grid))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("edges"), Clause::saying("is not sound"));
    return checkSound(edit.editable);
}

} // namespace core
