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

/// A part of the visible surface, sampled on a lattice of rays. Tools use it to aim before they
/// cut, and to show what they would cut. It decides no voxel.
class SurfacePatch {
public:
    /// Makes the rays inside an outline (mm in the view plane, right of and above the target),
    /// about @p across of them along its longer side.
    SurfacePatch(
        const core::OrthographicView& view, const std::vector<glm::dvec2>& outlineMm, int across);

    /// The question that picks the surface; take() takes its answer.
    [[nodiscard]] core::PickQuestion question(
        const core::Volume& volume, double threshold, const core::ClipRegion& clip) const;
    void take(const core::Volume& volume, const PickedVoxels& picked);

    /// Drops points that lie more than this behind the median of all depths.
    void dropBehind(double mm);
    /// Drops all points outside the largest part without jumps in depth (core/sculpt/ShellPeel.h,
    /// rule 2).
    void keepLargest(double jumpMm);

    /// The surface point nearest to the middle of the outline, LPS; none if no ray met anything.
    [[nodiscard]] std::optional<glm::dvec3> middleLps() const;
    /// The unit normal there, pointing into the material: that of the best-fitting plane.
    [[nodiscard]] glm::dvec3 normalLps() const;
    /// The sampled surface as squares in the pixels of a view.
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
