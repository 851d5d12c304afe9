// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace core {

/// The ways that parts of a surface go to edges, as they were found before it moved. A vertex goes
/// by the ways around it wherever it is by now, so that neither what slides along the surface nor
/// what restructuring makes needs a way of its own. World LPS, mm.
class EdgeTracks {
public:
    /// @param reachMm how far from a way it counts; about the length of the mesh's edges
    explicit EdgeTracks(double reachMm);

    /// @param unitNormal of the edge, outwards
    void add(const glm::dvec3& fromLps, const glm::dvec3& toLps, const glm::dvec3& unitNormal);

    /// From a place to the edge, straight across it; none: no way passes nearby. Cost ∝ the ways
    /// near it; may be asked by several threads at once.
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
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cells; ///< of m_reachMm
};

} // namespace core
