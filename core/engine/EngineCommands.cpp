// SPDX-License-Identifier: Apache-2.0
#include "core/engine/EngineCommands.h"

namespace core {

EngineCommand::EngineCommand() = default;
EngineCommand::EngineCommand(const EngineCommand& other) = default;
EngineCommand::EngineCommand(EngineCommand&& other) noexcept = default;
EngineCommand& EngineCommand::operator=(const EngineCommand& other) = default;
EngineCommand& EngineCommand::operator=(EngineCommand&& other) noexcept = default;
EngineCommand::~EngineCommand() = default;

} // namespace core
