// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core::demo {

/// The contrast-filled vessels of the head: carotid and vertebral arteries, the circle of Willis
/// with its branches over the brain, venous sinuses and the larger veins.
///
/// Trunks are given as curves. Branches walk over the surface of the brain, controlled by counters,
/// so that the tree is always the same. Head space (core/demo/HeadShapes.h). Immutable.
class VesselTree {
public:
    VesselTree();

    /// Signed distance in mm to the nearest vessel, at most reach().
    [[nodiscard]] float distance(const glm::vec3& p) const;
    static constexpr float reach() { return 3.0F; }

    struct Segment {
        glm::vec3 a;
        glm::vec3 b;
        float radiusA;
        float radiusB;
    };
    [[nodiscard]] std::span<const Segment> segments() const { return m_segments; }

private:
    void curve(std::span<const glm::vec3> points, float radiusFrom, float radiusTo, bool mirrored);
    void walk(glm::vec3 at, glm::vec3 heading, float radius, float lengthMm, int generation,
        std::uint32_t seed);
    void addSuperiorSagittalSinus();
    void addArteries();
    void addVeins();
    void sortIntoCells();

    std::vector<Segment> m_segments;
    std::vector<std::uint32_t> m_cellStarts; ///< index into m_cellSegments, by cell
    std::vector<std::uint16_t> m_cellSegments;
};

} // namespace core::demo
