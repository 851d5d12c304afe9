// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <array>
#include <cstdint>
#include <vector>

namespace core {

/// Where the voxels of a volume lie among the points of another lattice, in whole numbers.
///
/// Places have 30 fractional bits and are rounded once, where a slice begins. The point nearest to
/// a place has its index from half a step below to half a step above it; a place midway between two
/// is the greater one's, and within 2⁻¹³ of a step below midway counts as midway, so that what the
/// numbers of a header were rounded to does not decide.
class LatticeMap {
public:
    using Place = std::array<std::int64_t, 3>;
    static constexpr int bits = 30;
    static constexpr std::int64_t one = std::int64_t(1) << bits;

    LatticeMap(const VolumeGeometry& volume, const glm::dmat4& worldToLattice);

    /// False: steps or distances are beyond all measure, and nothing below may be asked.
    [[nodiscard]] bool isSound() const { return m_sound; }
    /// Each voxel lies on a point of the lattice, and no two neighbours farther apart than points
    /// are: nothing is lost or doubled from one to the other.
    [[nodiscard]] bool isOneToOne() const;
    /// The same of the voxels of a slice, wherever the slice lies.
    [[nodiscard]] bool hasUnitSteps() const;
    /// Within a hundredth of a step of a point.
    [[nodiscard]] static bool isPoint(std::int64_t place);

    /// Of voxel (0, j, k), and from one i to the next.
    [[nodiscard]] Place rowStart(int j, int k) const;
    [[nodiscard]] const Place& step() const { return m_perI; }

    [[nodiscard]] static std::int64_t nearest(std::int64_t place)
    {
        constexpr std::int64_t tolerance = one >> 13;
        return (place + one / 2 + tolerance) >> bits;
    }

private:
    glm::ivec3 m_size;
    Place m_perI{};
    Place m_perJ{};
    std::vector<Place> m_slices; ///< voxel (0, 0, k)
    bool m_sound = true;
};

} // namespace core
