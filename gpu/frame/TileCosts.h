// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <array>

namespace gpu {

/// What drawing costs, as tiles that were drawn have shown: how much of a picture is drawn at a
/// time, and how coarse it is at first. Costs are milliseconds per megapixel.
class TileCosts {
public:
    TileCosts();

    /// @param cubics whether what the scene wants interpolated by cubics is
    [[nodiscard]] double& of(const Scene& scene, bool cubics);
    /// Follows what a tile of so many pixels took.
    static void learn(double& cost, double milliseconds, double pixels);

    /// Pixels of the next tile. @param editing edits are running
    [[nodiscard]] static double pixelsAtOnce(double cost, bool editing, bool interacting);
    /// By what the first picture is coarser than the frame; 1: it comes at once.
    [[nodiscard]] static int coarseFactor(
        double cost, const glm::ivec2& sizePixels, bool editing, bool interacting);

private:
    /// Of slices, then by render mode; without cubics and with.
    std::array<std::array<double, 1 + renderModes>, 2> m_costs;
};

} // namespace gpu
