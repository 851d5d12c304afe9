// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace core {

/// Paths from parts of a surface to edges, recorded before the surface moves. A vertex uses the
/// paths around its present position, so that neither vertices that slide along the surface nor new
/// ones need a path of their own. World LPS, mm.
class EdgeTracks {
public:
    /// @param reachMm how far from a path it applies; about the length of the mesh's edges
    explicit EdgeTracks(double reachMm);

    /// @param unitNormal of the edge, outwards
    void add(const glm::dvec3& fromLps, const glm::dvec3& toLps, const glm::dvec3& unitNormal);

    /// The vector from a place to the edge, perpendicular to it; none: no path is near. Cost ∝ the
    /// paths near it; several threads may call it at once.
    [[nodiscard]] std::optional<glm::dvec3> leftMm(const glm::dvec3& placeLps) const;

private:
    struct Track {
        glm::dvec3 from{0.0};
        glm::dvec3 to{0.0};
        glm::dvec3 normal{0.0};
    };

    [[nodiscard]] glm::ivec3 cellOf(const glm::dvec3& placeLps) const;
    [[nodiscard]] static std::uint64_t keyOf(const glm::ivec3& cell);

    double m_reachMm;
    std::vector<Track> m_tracks;
    /// cells of size m_reachMm
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cells;
};

} // namespace core
