// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reenactment/MaskGrid.h"

#include <optional>

namespace reenact {

/// What somebody sees who knows the organ: where the mask has too much and too little of it.
class UserEye {
public:
    UserEye(const Mask& seen, const Mask& organ);

    struct Region {
        bool isMissing = false; ///< else it is too much
        MaskPart part;
        /// What is looked at first: volume times thickness.
        [[nodiscard]] double weight() const { return double(part.voxels.size()) * part.radius; }
    };
    /// Those more than a voxel off the organ's border, with what lies around them; the heaviest
    /// first. Where there are none, all of them.
    [[nodiscard]] std::vector<Region> regions() const;

    [[nodiscard]] const Mask& seen() const { return m_seen; }
    [[nodiscard]] const Mask& organ() const { return m_organ; }
    /// 1: to be mended, −1: would be spoilt, 0: does not matter. @param adds to the mask, else it
    /// takes from it
    [[nodiscard]] int worth(std::size_t at, bool adds) const;
    /// Of the organ's border, outwards positive, in voxels.
    [[nodiscard]] double offBorder(const glm::dvec3& index) const;
    [[nodiscard]] glm::dvec3 outwards(const glm::dvec3& index) const; ///< a unit vector
    /// Of the mask that is seen.
    [[nodiscard]] double offSeen(const glm::dvec3& index) const;

private:
    const Mask& m_seen;
    const Mask& m_organ;
    Field m_offOrgan;
    Field m_offSeen;
    Field m_soft;
};

} // namespace reenact
