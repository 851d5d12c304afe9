// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/aim/PickQuestion.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace ui {

/// What a stroke's view shows, as it was when the pen went down: depths on a grid of rays, asked
/// for just ahead of the pen. A stroke that carves never sees what it has carved itself, since
/// every ray is asked for before the brush comes near enough to change what it meets; so the path
/// does not depend on how often the pen reports or how long it rests.
class SeenSurface {
public:
    /// @param reachMm as far around the path as the stroke may change what is seen
    SeenSurface(
        const gpu::VolumeScene& scene, const core::Volume& volume, double radiusMm, double reachMm);

    /// Rays that a straight piece of path needs and that were not asked for yet; they count as
    /// asked for from now on. Points in the view plane, mm right of and above the target.
    [[nodiscard]] std::vector<std::pair<int, int>> cellsAhead(
        const glm::dvec2& from, const glm::dvec2& to);
    [[nodiscard]] core::PickQuestion question(const std::vector<std::pair<int, int>>& cells) const;
    void take(const std::vector<std::pair<int, int>>& cells, const PickedVoxels& picked);

    /// Where the pen meets what is seen; none: nothing is seen there.
    [[nodiscard]] std::optional<glm::dvec3> at(const glm::dvec2& planeMm) const;
    /// Points of a path lie no further apart.
    [[nodiscard]] double stepMm() const { return m_stepMm; }

private:
    [[nodiscard]] std::optional<double> depthOf(int x, int y) const;

    gpu::VolumeScene m_scene;
    core::Volume m_volume; ///< its description; no voxels
    glm::dvec3 m_right{0.0};
    glm::dvec3 m_up{0.0};
    glm::dvec3 m_forward{0.0};
    double m_radiusMm = 0.0;
    double m_stepMm = 0.0;
    double m_reachMm = 0.0;
    /// Depth behind the target's plane in mm; none: asked for, or nothing is seen.
    std::map<std::pair<int, int>, std::optional<double>> m_depths;
};

} // namespace ui
