// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/tools/SurfaceTool.h"
#include "core/refine/tools/ThinPlateSpline.h"

#include <optional>

namespace core {

/// What contours say of an erroneous region (seed B §4.4, 6.5): the red region that lies nearest to
/// them, and the surface that it is to have.
///
/// Open contours: a thin-plate spline through their points and the border of the region (the first
/// vertices around it that are not red), as heights above a plane that looks the way the region
/// opens. Each vertex has a place in that plane: those of the border their own, those within the
/// mean of their neighbours' (Tutte), so that the region lies over the plane once, however far it
/// bulges out. Closed contours, on planes that cross each other or not: a variational body through
/// them, and through the border.
class TemplateShape {
public:
    /// @param areaMm2 that a face is to have (SurfaceStrokeSettings); 0: the mean of the mesh
    /// Cost: some 100 ms. Errors: InvalidField (argument 1: no contours, no red region near them,
    /// points above one another, …).
    [[nodiscard]] static Result<TemplateShape> make(const SimplexMesh& mesh,
        const std::vector<TemplateContour>& contours, double areaMm2 = 0.0);

    /// Of the red region, ascending.
    [[nodiscard]] const std::vector<VertexId>& region() const { return m_region; }
    /// That it passes through: of the contours, then of the border.
    [[nodiscard]] const std::vector<glm::dvec3>& pointsLps() const { return m_points; }
    [[nodiscard]] bool isBody() const { return m_body.has_value(); }

    /// By place in region(): that of its vertices in the plane; empty for a body.
    [[nodiscard]] const std::vector<glm::dvec2>& places() const { return m_places; }
    /// @pre no body
    [[nodiscard]] glm::dvec3 at(const glm::dvec2& place) const;
    [[nodiscard]] glm::dvec2 placeOf(const glm::dvec3& positionLps) const;
    /// The way to it, about. @pre a body
    [[nodiscard]] glm::dvec3 wayMm(const glm::dvec3& positionLps) const;

    /// To look at before it is taken: where the region's vertices would lie, by place in region().
    [[nodiscard]] std::vector<glm::dvec3> preview(const SimplexMesh& mesh) const;

private:
    std::vector<VertexId> m_region;
    std::vector<glm::dvec3> m_points;
    std::vector<glm::dvec2> m_places;
    // The plane.
    glm::dvec3 m_origin{0.0};
    glm::dvec3 m_u{0.0};
    glm::dvec3 m_v{0.0};
    glm::dvec3 m_up{0.0};
    std::optional<ThinPlateSpline> m_spline;
    std::optional<VariationalBody> m_body;

    friend class TemplateMaker;
};

} // namespace core
