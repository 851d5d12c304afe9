// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <optional>

namespace core {

/// Rename or mute a sculpt layer, or have it count alone; absent fields stay.
struct ChangeLayer {
    int layer = 0; ///< id
    std::optional<QString> name{};
    std::optional<bool> muted{};
    std::optional<bool> solo{};
};

} // namespace core
