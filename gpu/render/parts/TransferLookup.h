// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VoxelEncoding.h"
#include "gpu/fields/textures/MacroCells.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace gpu {

/// A transfer function as the ray caster reads it: a row of colours and opacities per step over its
/// range of values.
class TransferLookup {
public:
    static constexpr int entryCount = 2048;

    TransferLookup();

    /// @param stepMm opacity per millimetre becomes 1 − (1 − opacity)^stepMm
    void set(const TransferFunction& function, double stepMm);

    [[nodiscard]] const Texture2D& texture() const { return m_texture; }
    /// Coefficients (x, y): a texel of the R16 intensity belongs to entry x · texel + y of the row,
    /// rounded down and clamped.
    [[nodiscard]] glm::dvec2 entryOfTexel(const core::VoxelEncoding& encoding) const;
    [[nodiscard]] static glm::dvec2 entryOfTexel(
        const TransferFunction& function, const core::VoxelEncoding& encoding);
    /// The row itself: four numbers per entry.
    [[nodiscard]] static std::vector<float> texelsOf(
        const TransferFunction& function, double stepMm);
    /// The range of values from the first to the last point.
    [[nodiscard]] double span() const { return m_highest - m_lowest; }

    /// The codes whose opacity is not zero, widened by one code at each end for interpolation.
    [[nodiscard]] static VisibleCodes visibleCodes(
        const TransferFunction& function, const core::VoxelEncoding& encoding);

private:
    Texture2D m_texture;
    TransferFunction m_function;
    double m_stepMm = 0.0;
    double m_lowest = 0.0;
    double m_highest = 1.0;
};

} // namespace gpu
