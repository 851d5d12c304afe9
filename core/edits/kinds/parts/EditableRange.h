// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/GrowBox.h"

#include <optional>
#include <vector>

namespace core {

/// Which voxels an edit of labels may change at all, whatever it is about; it reads the others as
/// ever. Each part that is given narrows it. Segments are named, never "those that are shown", so
/// that the edit contains what it reads and replay need not know what was visible.
struct EditableRange {
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    std::optional<GrowBox> box{}; ///< none: the whole volume
    /// Only voxels of one of these segments, by label, ascending; of an empty list: none at all.
    std::optional<std::vector<int>> inside{};
    /// Only voxels of none of these.
    std::optional<std::vector<int>> outside{};
    bool operator==(const EditableRange&) const = default;
};

} // namespace core
