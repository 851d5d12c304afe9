// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Program.h"
#include "gpu/gl/Texture3D.h"
#include "gpu/kernels/radiation/SparseRadiationKernel.h"
#include "gpu/scene/PassTarget.h"
#include "gpu/scene/Scene.h"
#include "gpu/scene/TilePlan.h"

#include <memory>
#include <optional>
#include <vector>

namespace gpu {

class VolumeTextures;

/// The seeds of a scene as the ray caster reads them (seeds.glsl): their radiation in tiles, one
/// for every brick of 16³ voxels that it reaches, 14 KB each. Nothing is allocated without seeds.
/// Engine thread.
class SeedDots {
public:
    /// The greatest number of tiles. Seeds in further bricks are not drawn.
    static constexpr std::size_t mostTiles = 6144;

    explicit SeedDots(const ShaderLibrary& library);

    /// Takes the seeds of a scene and computes their radiation if they have changed. Seeds outside
    /// the volume are left out.
    /// @return whether there are any
    bool set(const VolumeTextures& volume, const VolumeScene& scene);
    /// The blocks (RayBlocks) of a picture in which seeds are seen, as one rectangle of drawn
    /// pixels that may extend beyond the picture.
    [[nodiscard]] Tile blocksIn(const VolumeScene& scene, const PassTarget& target) const;
    /// Binds the tiles for a program of the variant SEEDS.
    void bind(Program& program) const;

private:
    void radiate(const VolumeTextures& volume, const std::vector<SceneSeed>& seeds);
    void clear();

    const ShaderLibrary& m_library;
    std::optional<SparseRadiationKernel> m_kernel; ///< made with the first seeds
    std::shared_ptr<const std::vector<SceneSeed>> m_seeds; ///< the seeds that the tiles hold
    glm::ivec3 m_volumeSize{0}; ///< the volume for which they were computed
    glm::dmat4 m_indexToWorld{0.0};
    Texture3D m_pages; ///< R32UI, one texel a brick: tile + 1; 0: none
    Texture3D m_tiles; ///< RG8: radiation, label
    glm::vec3 m_low{0.0f}; ///< in index space: the box that they reach
    glm::vec3 m_high{0.0f};
};

} // namespace gpu
