// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "gpu/scene/Scene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace bench {

/// VTK's filters for what a slice with a contour shows: vtkImageReslice and vtkCutter, which give
/// numbers and lines and draw neither.
class VtkPlaneView {
public:
    /// @param hounsfield x fastest, must outlive the view; the geometry is an unrotated box
    /// @param places LPS mm @param triangles of them
    VtkPlaneView(const core::VolumeGeometry& geometry, std::span<const std::int16_t> hounsfield,
        std::span<const glm::dvec3> places,
        std::span<const std::array<std::uint32_t, 3>> triangles);
    ~VtkPlaneView();

    /// Values and lines of the plane, anew.
    void update(const gpu::SliceScene& scene, const glm::ivec2& size, bool cubic);
    /// Of the last plane: values of the pixels, top row first.
    [[nodiscard]] std::vector<double> values() const;
    /// Ends of the lines, LPS mm.
    [[nodiscard]] std::vector<std::array<glm::dvec3, 2>> lines() const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace bench
