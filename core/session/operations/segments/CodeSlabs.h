// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <optional>

namespace core {

/// The parts of a box whose codes are read one after another (ReadCodes), so that no answer holds
/// more than 4 MiB; a part is a single slice where a slice holds more.
class CodeSlabs {
public:
    CodeSlabs() = default;
    explicit CodeSlabs(const VoxelBox& box)
        : m_left(box)
    {
    }
    /// Takes the next part, from the lowest slice upwards; nothing once all are taken, or if the
    /// box is empty.
    [[nodiscard]] std::optional<VoxelBox> take();

private:
    VoxelBox m_left; ///< what is not taken yet
};

} // namespace core
