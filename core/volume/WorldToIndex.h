// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

namespace core {

/// Converts places of the patient (LPS mm) to continuous voxel indices. With uneven slices it
/// interpolates between two of them, and continues beyond the outermost with the distance to its
/// neighbour.
class WorldToIndex {
public:
    /// @param geometry must outlive this
    explicit WorldToIndex(const VolumeGeometry& geometry);

    [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& lps) const;

private:
    const VolumeGeometry& m_geometry;
    glm::dmat4 m_inverse;
    glm::dvec3 m_normal{0.0};
    glm::dmat3 m_inSlice{1.0};
    std::vector<double> m_heights; ///< for uneven slices: their positions along the normal
};

} // namespace core
