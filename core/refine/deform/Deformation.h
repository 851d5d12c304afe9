// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/ExternalForce.h"
#include "core/refine/mesh/SimplexMeshEdit.h"

#include <span>

namespace core {

/// How a surface moves (seed B §6.1, 6.2, 6.4):
/// p(t+1) = p(t) + (1 − damping) (p(t) − p(t−1)) + timeStep (internal F_int + external F_ext).
struct DeformationSettings {
    double timeStep = 0.45;
    double damping = 0.65;
    double internal = 0.6; ///< weight
    double external = 1.0; ///< weight
    /// Times the distance of its neighbours, or the mean of such distances: no external force
    /// counts more.
    double stride = 0.5;
    int curvatureRounds = 2; ///< over so many neighbours the curvature is to be even
    double negligibleMm = 0.01; ///< a force below this
    int quietSteps = 4; ///< … so many times puts a vertex to rest
    double stirringMm = 0.1; ///< a force beyond this wakes the neighbours
    int shares = 0; ///< into which the work is cut, for threads; 0: as many as it is worth
};

/// What a step did.
struct DeformationStep {
    std::size_t active = 0; ///< vertices that it concerned
    double greatestForceMm = 0.0; ///< of the sums
    double greatestMoveMm = 0.0;
};

/// A surface in motion: which of its vertices are active, and how fast they are. Only these cost.
///
/// Vertices become active when they are told to, unless green, or when a large force works on a
/// neighbour; they come to rest after several steps with negligible forces, or when told to. What a
/// step does depends on mesh, forces and what came before, not on the number of threads.
class Deformation {
public:
    explicit Deformation(const DeformationSettings& settings)
        : m_settings(settings)
    {
    }

    void activate(const SimplexMesh& mesh, std::span<const VertexId> vertices);
    void activateAll(const SimplexMesh& mesh);
    void rest(std::span<const VertexId> vertices);
    void restAll();
    /// After the structure changed: these vertices are new or have other neighbours. They are
    /// active, without speed; what no longer exists is forgotten.
    void restructured(const SimplexMesh& mesh, std::span<const VertexId> vertices);

    /// Those that are active, ascending.
    [[nodiscard]] const std::vector<VertexId>& active() const { return m_active; }

    /// Moves the active vertices once; the external forces add up.
    DeformationStep step(SimplexMeshEdit& edit, std::span<const ExternalForce* const> forces,
        SurfaceGuide* guide = nullptr);

private:
    struct Motion {
        glm::dvec3 speed{0.0};
        std::uint8_t quiet = 0; ///< steps without a force worth the name
        bool isActive = false;
    };
    struct Pull {
        glm::dvec3 force{0.0};
        glm::dvec3 place{0.0};
    };

    void measureCurvatures(const SimplexMesh& mesh);
    /// The mean of a vertex's and that of its neighbours'.
    [[nodiscard]] glm::dvec3 evenNormal(const SimplexMesh& mesh, VertexId id) const;
    void forgetInactive();

    DeformationSettings m_settings;
    std::vector<VertexId> m_active;
    std::vector<Motion> m_motions; ///< by vertex
    // Of the step in progress, kept for their memory.
    std::vector<VertexId> m_measured; ///< active ones, then who is around them
    std::vector<std::uint32_t> m_stamps; ///< by vertex: the step in which it was measured
    std::uint32_t m_stamp = 0;
    std::vector<glm::dvec3> m_normals; ///< by vertex
    std::vector<double> m_curvatures; ///< by vertex
    std::vector<double> m_evened; ///< by vertex
    std::vector<Pull> m_pulls; ///< by place among the active ones
};

} // namespace core
