// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <array>

namespace gpu {

/// How long drawing takes, learnt from the tiles that were drawn. From this follow the size of the
/// next tile and the coarseness of a first picture. Costs are milliseconds per megapixel.
class TileCosts {
public:
    TileCosts();

    /// @param cubics whether cubic interpolation is used where the scene wants it
    [[nodiscard]] double& of(const Scene& scene, bool cubics);
    /// Adapts a cost to what a tile of so many pixels took.
    static void learn(double& cost, double milliseconds, double pixels);

    /// How many pixels the next tile should have.
    /// @param editing edits are running
    [[nodiscard]] static double pixelsAtOnce(double cost, bool editing, bool interacting);
    /// The factor, on each axis, by which the first picture is coarser than the frame; 1 if it is
    /// drawn in full at once.
    [[nodiscard]] static int coarseFactor(
        double cost, const glm::ivec2& sizePixels, bool editing, bool interacting);

private:
    /// First index: without and with cubic interpolation. Second index: slices, then each render
    /// mode.
    std::array<std::array<double, 1 + renderModes>, 2> m_costs;
};

} // namespace gpu
