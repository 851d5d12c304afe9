// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/fields/bricks/BrickField.h"
#include "gpu/fields/bricks/FieldPrograms.h"
#include "gpu/gl/Buffer.h"

#include <bitset>
#include <functional>
#include <span>

namespace gpu {

/// Computes radiation (the smoothed cut surface) from coverage, and the segmentation map from
/// labels, brick by brick: the exact integer Gaussian with the rule for thin parts
/// (core/sculpt/radiation/Radiation.h; radiation*.comp).
///
/// Cost: about 40 000 fetches and additions for a whole brick, less for a part of one, and little
/// for parts that are uniform with their surroundings. Engine thread only.
class RadiationKernel {
public:
    /// How far, in voxels, a changed voxel has an effect: three for the blur, one for the rule for
    /// thin parts.
    static constexpr int reach = 4;

    /// The part of a brick that is to be updated.
    struct Region {
        std::uint32_t brick = 0;
        glm::ivec3 low{0}; ///< first voxel, within the brick
        glm::ivec3 high{core::BrickGrid::side}; ///< one past the last
    };

    /// @param programs outlive the kernel
    RadiationKernel(RadiationPrograms& programs, const core::BrickGrid& grid);

    /// @param target dense R8UI texture of the volume
    void updateFromCoverage(std::span<BrickField* const> layers, const Texture3D& target,
        std::span<const Region> regions);
    /// The label planes: dense R8UI textures, at least one.
    using Planes = std::span<const Texture3D* const>;
    /// Updates the segmentation map. A voxel counts as 255 if it has a shown label in any plane.
    void updateFromLabels(Planes planes, const std::bitset<256>& shown, const Texture3D& target,
        std::span<const Region> regions);
    /// How a segment would be at a tolerance (toleranceLabel.glsl).
    struct AtTolerance {
        const Texture3D& tolerances;
        BrickField& seedWords;
        int label = 0;
        int tolerance = 0;
        std::size_t place = 0; ///< of its label plane among the planes
    };
    void updateFromLabels(Planes planes, const AtTolerance& segment, const std::bitset<256>& shown,
        const Texture3D& target, std::span<const Region> regions);

    /// Where a footprint is written: voxel v to texel v + shift of an R8UI texture.
    struct Footprint {
        const Texture3D& target;
        glm::ivec3 shift{0};
    };
    /// Updates the footprint of what one layer covers and earlier layers do not: min(coverage, 255
    /// − the greatest coverage of an earlier layer).
    void updateFootprint(BrickField& layer, std::span<BrickField* const> before,
        const Footprint& footprint, std::span<const Region> regions);
    /// Updates the footprint of the voxels with a label in any plane.
    void updateFootprint(
        Planes planes, int label, const Footprint& footprint, std::span<const Region> regions);

private:
    void update(const Footprint& footprint, std::span<const Region> regions,
        const std::function<void(unsigned count)>& gather);
    void gatherLayers(std::span<BrickField* const> layers, bool subtract, unsigned count);
    /// @param first whether nothing was gathered before
    void gatherLabels(Planes planes, const std::bitset<256>& shown, bool first, unsigned count);
    void gatherMore();

    RadiationPrograms& m_programs;
    core::BrickGrid m_grid;
    std::size_t m_bricksPerPass; ///< capacity of the buffers
    Buffer m_regions;
    Buffer m_field;
    Buffer m_summaries;
    Buffer m_scratchA;
    Buffer m_scratchB;
};

} // namespace gpu
