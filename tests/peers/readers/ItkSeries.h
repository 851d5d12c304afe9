// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace peer {

/// What ITK makes of a folder with one series, by GDCM: what 3D Slicer and ITK-SNAP read with.
struct ItkSeries {
    std::string error; ///< not empty: why it cannot be read, and all else is void
    glm::ivec3 size{0};
    std::vector<std::int16_t> values; ///< x fastest, slices sorted along their normal
    double milliseconds = 0.0; ///< headers and pixels, files sorted
};

ItkSeries readItkSeries(const std::string& folder);

} // namespace peer
