// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/tools/SurfaceTool.h"
#include "core/refine/tools/ThinPlateSpline.h"

#include <optional>

namespace core {

class Progress;

/// Which shapes contours can define.
enum class TemplateForm : std::uint8_t {
    /// Open contours define a surface over a plane, closed ones a body; a mixture is refused.
    OfBefore,
    /// Any mixture of open and closed contours defines a body (ContourBody.h).
    Body
};

/// The shape that contours define for an erroneous region (seed B §4.4, 6.5). The region is the red
/// one nearest to the contours.
///
/// Open contours define a thin-plate spline through their points and the border of the region (the
/// first vertices around it that are not red), as heights above a plane that faces the way in which
/// the region opens. Each vertex has a place in that plane: those of the border have their own, the
/// others the mean of their neighbours' places (Tutte), so that the region covers the plane only
/// once, however far it bulges. Closed contours, whether or not their planes cross, define a
/// variational body through them and through the border. With TemplateForm::Body all do.
class TemplateShape {
public:
    /// @param areaMm2 intended area of a face (SurfaceStrokeSettings); 0: the mean of the mesh
    /// @param progress asked whether it was cancelled; null: it never is
    /// Cost: about 100 ms. Errors: InvalidField (argument 1: no contours, no red region near them,
    /// points above one another, …), Cancelled.
    [[nodiscard]] static Result<TemplateShape> make(const SimplexMesh& mesh,
        const std::vector<TemplateContour>& contours, double areaMm2 = 0.0,
        TemplateForm form = TemplateForm::OfBefore, const Progress* progress = nullptr);

    /// The vertices of the red region, ascending.
    [[nodiscard]] const std::vector<VertexId>& region() const { return m_region; }
    /// The points through which the shape passes: those of the contours, then those of the border.
    [[nodiscard]] const std::vector<glm::dvec3>& pointsLps() const { return m_points; }
    [[nodiscard]] bool isBody() const { return m_body.has_value(); }
    [[nodiscard]] TemplateForm form() const { return m_form; }
    /// Positive inside the body, about the distance from its surface in mm. @pre a body
    [[nodiscard]] VariationalBody::Value valueAt(const glm::dvec3& positionLps) const;

    /// By index in region(): the places of its vertices in the plane; empty for a body.
    [[nodiscard]] const std::vector<glm::dvec2>& places() const { return m_places; }
    /// @pre no body
    [[nodiscard]] glm::dvec3 at(const glm::dvec2& place) const;
    [[nodiscard]] glm::dvec2 placeOf(const glm::dvec3& positionLps) const;
    /// The approximate vector from a position to the surface of the body. @pre a body
    [[nodiscard]] glm::dvec3 wayMm(const glm::dvec3& positionLps) const;

    /// Where the region's vertices would be, by index in region(); for display before it is
    /// applied.
    [[nodiscard]] std::vector<glm::dvec3> preview(const SimplexMesh& mesh) const;

private:
    TemplateForm m_form = TemplateForm::OfBefore;
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
    /// With TemplateForm::Body: the body counts only inside this box. Far from all that was drawn,
    /// the function may have further parts that the user did not mean.
    glm::dvec3 m_leastLps{0.0};
    glm::dvec3 m_mostLps{0.0};

    friend class TemplateMaker;
};

} // namespace core
