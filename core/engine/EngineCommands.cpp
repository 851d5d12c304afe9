// SPDX-License-Identifier: Apache-2.0
#include "core/engine/EngineCommands.h"

namespace core {

EngineEdit::EngineEdit() = default;
EngineEdit::EngineEdit(const EngineEdit& other) = default;
EngineEdit::EngineEdit(EngineEdit&& other) noexcept = default;
EngineEdit& EngineEdit::operator=(const EngineEdit& other) = default;
EngineEdit& EngineEdit::operator=(EngineEdit&& other) noexcept = default;
EngineEdit::~EngineEdit() = default;

EngineCommand::EngineCommand() = default;
EngineCommand::EngineCommand(const EngineCommand& other) = default;
EngineCommand::EngineCommand(EngineCommand&& other) noexcept = default;
EngineCommand& EngineCommand::operator=(const EngineCommand& other) = default;
EngineCommand& EngineCommand::operator=(EngineCommand&& other) noexcept = default;
EngineCommand::~EngineCommand() = default;

EditStatistics statisticsOf(const ChangeFacts& facts)
{
    EditStatistics statistics;
    statistics.voxelsChanged = facts.voxelsChanged;
    statistics.bricks = facts.bricks;
    return statistics;
}

Result<void> checkSound(const EraseLabel& edit, const BrickGrid&)
{
    if (edit.label == 0)
        return failure(
            ErrorCode::InvalidField, QStringLiteral("label"), QStringLiteral("0 is no segment"));
    return {};
}

Result<void> checkSound(const PaintLabel& edit, const BrickGrid&)
{
    if (edit.label == 0)
        return failure(
            ErrorCode::InvalidField, QStringLiteral("label"), QStringLiteral("0 is no segment"));
    if (!isSound(edit.frame))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("frame"), QStringLiteral("is not sound"));
    return {};
}

Result<void> checkSound(const CapsuleCut& edit, const BrickGrid&)
{
    if (!isSound(edit.frame))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("frame"), QStringLiteral("is not sound"));
    if (!isSound(edit.hidden))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("hidden"), QStringLiteral("is not sound"));
    return {};
}

Result<void> checkEdit(const EngineEdit& edit, const BrickGrid& grid)
{
    return std::visit([&grid](const auto& known) { return checkSound(known, grid); }, edit);
}

} // namespace core
