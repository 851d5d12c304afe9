// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace peer {

/// What ITK's NRRD reader, which 3D Slicer reads segmentations with, finds in a file of bytes.
struct ItkNrrd {
    std::string error; ///< not empty: why it cannot be read, and all else is void
    glm::ivec3 size{0};
    glm::dmat4 indexToWorld{1.0}; ///< LPS mm
    std::vector<std::uint8_t> voxels; ///< x fastest
    std::map<std::string, std::string> words; ///< the key/value pairs among others
};

ItkNrrd readItkNrrd(const std::string& file);

} // namespace peer
