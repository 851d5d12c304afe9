// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/aim/PickQuestion.h"

#include <bitset>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace ui {

/// The surface that a view showed when the pen went down, as depths on a grid of rays. Rays are
/// requested just ahead of the pen. A stroke that carves never sees what it has carved itself,
/// because every ray is requested before the brush comes near enough to change its result. So the
/// path does not depend on how often the pen reports or how long it rests.
class SeenSurface {
public:
    /// @param reachMm how far from the path the stroke may change what is seen
    /// @param segments labels whose voxels alone are seen, whatever lies around them; none: what
    /// the view shows of the volume
    SeenSurface(const gpu::VolumeScene& scene, const core::Volume& volume, double radiusMm,
        double reachMm, std::optional<std::bitset<256>> segments = std::nullopt);

    /// The rays that a straight piece of path needs and that were not requested yet; from now on
    /// they count as requested. Points are in the view plane, mm right of and above the target.
    [[nodiscard]] std::vector<std::pair<int, int>> cellsAhead(
        const glm::dvec2& from, const glm::dvec2& to);
    [[nodiscard]] core::PickQuestion question(const std::vector<std::pair<int, int>>& cells) const;
    void take(const std::vector<std::pair<int, int>>& cells, const PickedVoxels& picked);

    /// Where the pen meets the surface, LPS mm; none if nothing is seen there.
    [[nodiscard]] std::optional<glm::dvec3> at(const glm::dvec2& planeMm) const;
    /// The greatest distance between points of a path.
    [[nodiscard]] double stepMm() const { return m_stepMm; }

private:
    [[nodiscard]] std::optional<double> depthOf(int x, int y) const;

    gpu::VolumeScene m_scene;
    core::Volume m_volume; ///< the volume's description, without voxels
    glm::dvec3 m_right{0.0};
    glm::dvec3 m_up{0.0};
    glm::dvec3 m_forward{0.0};
    std::optional<std::bitset<256>> m_segments;
    double m_radiusMm = 0.0;
    double m_stepMm = 0.0;
    double m_reachMm = 0.0;
    /// Depth behind the target's plane in mm; none if requested but not answered, or if nothing is
    /// seen.
    std::map<std::pair<int, int>, std::optional<double>> m_depths;
};

} // namespace ui
