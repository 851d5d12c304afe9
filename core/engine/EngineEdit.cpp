// SPDX-License-Identifier: Apache-2.0
#include "core/engine/EngineEdit.h"

#include <type_traits>

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

namespace {

template <class E, class... Es> constexpr bool isAnyOf = (std::is_same_v<E, Es> || ...);

} // namespace

bool mayTakeLong(const EngineEdit& edit)
{
    return std::visit(
        [](const auto& known) {
            return isAnyOf<std::decay_t<decltype(known)>, SpreadLabels, LabelThreshold,
                LabelScissors, MapLabels, MapPlanes>;
        },
        edit);
}

} // namespace core
