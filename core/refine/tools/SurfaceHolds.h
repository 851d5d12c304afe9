// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/tools/ToolBehaviour.h"

#include <span>

namespace core {

/// Keeps the surface of a stroke in place where the tool has left it. Each vertex that does not
/// follow the mask has a weak spring to its place; a vertex that the tool has touched cannot leave
/// a plane.
class SurfaceHolds final : public ExternalForce, public SurfaceGuide {
public:
    /// @param isMaskThere whether yellow vertices follow the mask
    SurfaceHolds(ToolBehaviour& tool, bool isMaskThere)
        : m_tool(tool)
        , m_isMaskThere(isMaskThere)
    {
    }

    /// To be called before a step with the vertices that take part. It registers them; the place of
    /// new ones follows from the vertices around them.
    void learn(const SimplexMesh& mesh, std::span<const VertexId> active);
    /// To be called for vertices that were stopped before they reached their place: they are held
    /// where they are.
    void stopped(const SimplexMesh& mesh, std::span<const VertexId> vertices);
    /// From now on the tool no longer holds yellow vertices.
    void letYellowGo() { m_isYellowFree = true; }

    [[nodiscard]] glm::dvec3 forceMm(const SurfacePoint& point) const override;
    void guide(const SurfacePoint& point, glm::dvec3& forceMm, glm::dvec3& placeLps) override;

    /// Of @p active, the greatest distance that a vertex gripped in the last step still had to go.
    [[nodiscard]] double leftMm(std::span<const VertexId> active) const;
    [[nodiscard]] bool isGripped(VertexId id) const
    {
        return id < m_holds.size() && m_holds[id].gripped == m_step;
    }

private:
    struct Hold {
        glm::dvec3 home{0.0};
        glm::dvec3 normal{0.0}; ///< 0: not touched
        glm::dvec3 last{0.0}; ///< where it was left; a vertex that is elsewhere is another one
        double leftMm = 0.0;
        std::uint32_t gripped = 0; ///< the last step in which it was
        bool isKnown = false;
        bool isMade = false; ///< created by restructuring
    };
    [[nodiscard]] bool follows(SurfaceMark mark) const
    {
        return m_isMaskThere && mark == SurfaceMark::Yellow;
    }
    [[nodiscard]] bool isSame(const SimplexMesh& mesh, VertexId id) const;
    /// For a vertex that is new or takes part for the first time: if it is between two held ones,
    /// it is held as they are.
    [[nodiscard]] Hold held(const SimplexMesh& mesh, VertexId id) const;

    ToolBehaviour& m_tool;
    bool m_isMaskThere;
    bool m_isYellowFree = false;
    std::uint32_t m_step = 0;
    VertexId m_slotsAtFirst = 0; ///< greater ids are new
    std::vector<Hold> m_holds; ///< by vertex
};

} // namespace core
