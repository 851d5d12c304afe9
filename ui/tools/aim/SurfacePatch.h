// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/volume/ClipRegion.h"
#include "ui/geometry/ViewContext.h"
#include "ui/tools/aim/PickQuestion.h"

#include <QPolygonF>

#include <optional>
#include <vector>

namespace ui {

/// A part of the surface as a view shows it, known on a lattice of rays: what tools go by before
/// they cut, and what they show. It decides no voxel by itself.
class SurfacePatch {
public:
    /// The rays inside an outline (mm in the view plane, right of and above the target), about
    /// @p across of them along its longer side.
    SurfacePatch(
        const core::OrthographicView& view, const std::vector<glm::dvec2>& outlineMm, int across);

    /// What is to be picked, and what was.
    [[nodiscard]] core::PickQuestion question(
        const core::Volume& volume, double threshold, const core::ClipRegion& clip) const;
    void take(const core::Volume& volume, const PickedVoxels& picked);

    /// Forgets what lies more than this behind the middle of all depths.
    void dropBehind(double mm);
    /// Forgets all but the largest part without jumps (core/sculpt/MaskPeel.h, rule 2).
    void keepLargest(double jumpMm);

    /// The surface nearest to the middle of the outline, LPS; none: nothing is met there.
    [[nodiscard]] std::optional<glm::dvec3> middleLps() const;
    /// Its normal there, into the material: of the plane that fits best. Unit.
    [[nodiscard]] glm::dvec3 normalLps() const;
    /// What is met, as a picture of it in a view: squares of the lattice.
    [[nodiscard]] std::vector<QPolygonF> squares(const ViewContext& view) const;

private:
    using Depth = std::optional<double>; ///< behind the target's plane, mm
    [[nodiscard]] glm::dvec2 planeMm(const glm::ivec2& at) const;
    [[nodiscard]] glm::dvec3 lps(const glm::ivec2& at) const;
    [[nodiscard]] std::size_t place(const glm::ivec2& at) const;
    [[nodiscard]] std::optional<glm::ivec2> middle() const;

    core::OrthographicView m_view;
    glm::dmat3 m_axes{1.0}; ///< right, up, forward
    glm::dvec2 m_middleMm{0.0};
    glm::dvec2 m_firstMm{0.0};
    double m_stepMm = 1.0;
    glm::ivec2 m_size{0};
    std::vector<glm::ivec2> m_rays; ///< those inside the outline
    std::vector<Depth> m_depths; ///< by rows
};

} // namespace ui
