// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace test {

/// ITK's ConnectedThresholdImageFilter, faces only: 1 where it grew, x fastest. Nothing where the
/// tests were built without ITK (libinsighttoolkit5-dev).
[[nodiscard]] std::optional<std::vector<std::uint8_t>> connectedThreshold(const glm::ivec3& size,
    std::span<const std::uint16_t> codes, int low, int high, const std::vector<glm::ivec3>& seeds);

} // namespace test
