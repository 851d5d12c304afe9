// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/GrowBox.h"

#include <optional>
#include <vector>

namespace core {

/// Limits which voxels an edit of labels may change; it does not limit what the edit reads. Each
/// part that is given narrows the range. Segments are listed by label, never as "those that are
/// shown", so that the edit contains everything that it depends on and replay need not know what
/// was visible.
struct EditableRange {
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    std::optional<GrowBox> box{}; ///< none: the whole volume
    /// Only voxels of one of these segments, labels ascending. An empty list: no voxel at all.
    std::optional<std::vector<int>> inside{};
    /// Only voxels that belong to none of these segments, labels ascending.
    std::optional<std::vector<int>> outside{};
    bool operator==(const EditableRange&) const = default;
};

} // namespace core
