// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstdint>
#include <optional>

namespace core {

/// The segment that receives voxels: one that is there, or a new one.
struct SegmentChoice {
    std::optional<int> segment{}; ///< label; none: a new one
    QString name{}; ///< of the new one
    std::uint32_t rgb = 0;
};

} // namespace core
