// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

namespace core {

/// Places of the patient (LPS mm) as continuous voxel indices, also where slices lie unevenly:
/// there between two of them, or beyond the outermost as far as its neighbour is away.
class WorldToIndex {
public:
    /// @param geometry must outlive it
    explicit WorldToIndex(const VolumeGeometry& geometry);

    [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& lps) const;

private:
    const VolumeGeometry& m_geometry;
    glm::dmat4 m_inverse;
    glm::dvec3 m_normal{0.0};
    glm::dmat3 m_inSlice{1.0};
    std::vector<double> m_heights; ///< of uneven slices along their normal
};

} // namespace core
