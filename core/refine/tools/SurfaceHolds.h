// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/tools/ToolBehaviour.h"

#include <span>

namespace core {

/// Where the vertices of a stroke belong: what keeps a surface in place that the tool has left.
/// A weak spring to its place for each vertex that is not to follow the mask; and for those that
/// the tool has touched, a plane that they do not leave.
class SurfaceHolds final : public ExternalForce, public SurfaceGuide {
public:
    /// @param isMaskThere yellow vertices follow it
    SurfaceHolds(ToolBehaviour& tool, bool isMaskThere)
        : m_tool(tool)
        , m_isMaskThere(isMaskThere)
    {
    }

    /// Before a step, of those that it will concern: knows them afterwards, new ones by what is
    /// around them.
    void learn(const SimplexMesh& mesh, std::span<const VertexId> active);
    /// Yellow vertices are free of the tool.
    void letYellowGo() { m_isYellowFree = true; }

    [[nodiscard]] glm::dvec3 forceMm(const SurfacePoint& point) const override;
    void guide(const SurfacePoint& point, glm::dvec3& forceMm, glm::dvec3& placeLps) override;

    /// How far what the tool had in its grip in the last step had to go at most, of @p active.
    [[nodiscard]] double leftMm(std::span<const VertexId> active) const;
    [[nodiscard]] bool isGripped(VertexId id) const
    {
        return id < m_holds.size() && m_holds[id].gripped == m_step;
    }

private:
    struct Hold {
        glm::dvec3 home{0.0};
        glm::dvec3 normal{0.0}; ///< 0: it was not touched
        glm::dvec3 last{0.0}; ///< where it was left: a vertex elsewhere is another
        double leftMm = 0.0;
        std::uint32_t gripped = 0; ///< in which step it was last
        bool isKnown = false;
        bool isMade = false; ///< by restructuring
    };
    [[nodiscard]] bool follows(SurfaceMark mark) const
    {
        return m_isMaskThere && mark == SurfaceMark::Yellow;
    }
    [[nodiscard]] bool isSame(const SimplexMesh& mesh, VertexId id) const;
    /// A vertex that is new, or concerned for the first time: between two that are held it is held
    /// as they are.
    [[nodiscard]] Hold held(const SimplexMesh& mesh, VertexId id) const;

    ToolBehaviour& m_tool;
    bool m_isMaskThere;
    bool m_isYellowFree = false;
    std::uint32_t m_step = 0;
    VertexId m_slotsAtFirst = 0; ///< ids beyond are new
    std::vector<Hold> m_holds; ///< by vertex
};

} // namespace core
