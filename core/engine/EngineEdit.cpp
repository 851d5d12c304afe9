// SPDX-License-Identifier: Apache-2.0
#include "core/engine/EngineEdit.h"

namespace core {

EngineEdit::EngineEdit() = default;
EngineEdit::EngineEdit(const EngineEdit& other) = default;
EngineEdit::EngineEdit(EngineEdit&& other) noexcept = default;
EngineEdit& EngineEdit::operator=(const EngineEdit& other) = default;
EngineEdit& EngineEdit::operator=(EngineEdit&& other) noexcept = default;
EngineEdit::~EngineEdit() = default;

Result<void> checkEdit(const EngineEdit& edit, const BrickGrid& grid)
{
    return std::visit([&grid](const auto& known) { return checkSound(known, grid); }, edit);
}

} // namespace core
