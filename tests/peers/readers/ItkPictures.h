// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace peer {

/// What ITK makes of pictures: one TIFF of several pages, or PNG and TIFF files in their order.
struct ItkPictures {
    std::string error; ///< not empty: why they cannot be read, and all else is void
    glm::ivec3 size{0};
    std::vector<double> values; ///< x fastest
};

ItkPictures readItkPictures(const std::vector<std::string>& files);

} // namespace peer
