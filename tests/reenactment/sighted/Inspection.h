// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reenactment/sighted/Belief.h"
#include "tests/reenactment/sighted/Reader.h"

namespace reenact {

/// How a user looks a mask over: scrolls through every other slice, then through all of them where
/// something seemed wrong. From then on the organ is known as far as it ever will be; after each
/// stroke its contour is held to that.
class Inspection {
public:
    /// @param seen the mask at the beginning
    Inspection(Reader& reader, const core::VolumeGeometry& geometry, const Mask& seen);

    /// As it was read.
    [[nodiscard]] const Mask& organ() const { return m_organ; }
    /// Voxels in which what is seen is not the organ as it was read.
    [[nodiscard]] std::size_t wrongIn(const Mask& seen) const { return differing(seen, m_organ); }
    /// What the user would have in its place (meantOf()).
    [[nodiscard]] Mask meant(const Mask& seen) const;
    /// Around some voxels, the share of what was read that lies on an edge of the grey values.
    [[nodiscard]] double edgeShareNear(const std::vector<glm::ivec3>& voxels) const;

    /// Whether a slice was scrolled to.
    [[nodiscard]] bool hasOpened(int slice) const { return m_belief.has(slice); }
    /// Opens a plane through a place, to draw on it.
    [[nodiscard]] SeenPlane open(
        const glm::dvec3& placeLps, const glm::dvec3& normalLps, const Mask& seen);

private:
    void open(int slice, const Mask& seen);

    Reader& m_reader;
    core::VolumeGeometry m_geometry;
    Belief m_belief;
    std::map<int, SeenPlane> m_views; ///< by slice
    Mask m_organ;
};

} // namespace reenact
