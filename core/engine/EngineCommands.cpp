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

} // namespace core
