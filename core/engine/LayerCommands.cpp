// SPDX-License-Identifier: Apache-2.0
#include "core/engine/LayerCommands.h"

namespace core {

Result<void> checkSound(const CapsuleCut& edit, const BrickGrid&)
{
    if (!isSound(edit.frame))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("frame"), Clause::saying("is not sound"));
    if (!isSound(edit.hidden))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("hidden"), Clause::saying("is not sound"));
    return {};
}

} // namespace core
