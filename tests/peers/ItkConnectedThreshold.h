// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace peer {

struct ItkGrown {
    std::vector<std::uint8_t> mask; ///< 0 or 1, x fastest
    double milliseconds = 0.0; ///< of the filter alone
};

/// itk::ConnectedThresholdImageFilter, face connectivity (6), bounds inclusive.
/// @param values x fastest; instantiated for std::int16_t and float
template <class Value>
ItkGrown itkConnectedThreshold(const glm::ivec3& size, std::span<const Value> values,
    std::span<const glm::ivec3> seeds, Value lower, Value upper);

} // namespace peer
