// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "gpu/scene/Scene.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace bench {

/// VTK drawing the same scene of the same volume into a window of the same size.
class VtkVolumeView {
public:
    enum class Mapper { Gpu, FixedPoint };

    /// @param hounsfield x fastest, must outlive the view; the geometry is an unrotated box
    VtkVolumeView(const core::VolumeGeometry& geometry, std::span<const std::int16_t> hounsfield,
        const glm::ivec2& size, Mapper mapper);
    ~VtkVolumeView();

    /// Mode, threshold, transfer function and window of @p scene; full resolution, samples
    /// @p sampleMm apart.
    void setUp(const gpu::VolumeScene& scene, double sampleMm);
    /// Draws with the scene's camera and reads the picture: RGBA, top row first.
    std::vector<std::uint8_t> draw(const gpu::VolumeScene& scene);
    [[nodiscard]] std::string rendererName(); ///< GL_RENDERER; after draw()

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace bench
