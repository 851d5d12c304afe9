// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <array>
#include <cstdint>
#include <vector>

namespace core {

/// Finds the voxels of a volume on the lattice of another one, in integers.
///
/// Positions have 30 fractional bits and are rounded once, at the beginning of a slice. The nearest
/// lattice point has an index between half a step below and half a step above the position. A
/// position midway between two belongs to the greater one; within 2⁻¹³ of a step below midway
/// counts as midway, so that the rounding of numbers in a header does not decide.
class LatticeMap {
public:
    using Place = std::array<std::int64_t, 3>;
    static constexpr int bits = 30;
    static constexpr std::int64_t one = std::int64_t(1) << bits;

    LatticeMap(const VolumeGeometry& volume, const glm::dmat4& worldToLattice);

    /// False: steps or distances are too large, and the functions below must not be called.
    [[nodiscard]] bool isSound() const { return m_sound; }
    /// Each voxel lies on a point of the lattice, and neighbouring voxels on neighbouring points:
    /// nothing is lost or doubled.
    [[nodiscard]] bool isOneToOne() const;
    /// The same for the voxels within a slice, wherever the slice lies.
    [[nodiscard]] bool hasUnitSteps() const;
    /// Whether a position is within a hundredth of a step of a point.
    [[nodiscard]] static bool isPoint(std::int64_t place);

    /// Position of voxel (0, j, k), and the step from one i to the next.
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
