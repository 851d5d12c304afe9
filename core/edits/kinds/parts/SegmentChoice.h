// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstdint>
#include <optional>

namespace core {

/// The segment that receives voxels: an existing one or a new one.
struct SegmentChoice {
    std::optional<int> segment{}; ///< label; none: a new one
    QString name{}; ///< of a new segment
    std::uint32_t rgb = 0;
};

} // namespace core
