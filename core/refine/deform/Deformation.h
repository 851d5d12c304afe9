// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/ExternalForce.h"
#include "core/refine/mesh/SimplexMeshEdit.h"

#include <span>

namespace core {

/// Parameters of the motion of a surface (seed B §6.1, 6.2, 6.4):
/// p(t+1) = p(t) + (1 − damping) (p(t) − p(t−1)) + timeStep (internal F_int + external F_ext).
struct DeformationSettings {
    double timeStep = 0.45;
    double damping = 0.65;
    double internal = 0.6; ///< weight
    double external = 1.0; ///< weight
    /// The greatest external force that counts, as a multiple of the mean distance to the
    /// neighbours (or of the mean of such distances).
    double stride = 0.5;
    int curvatureRounds = 2; ///< over this many rings of neighbours the curvature is averaged
    double negligibleMm = 0.01; ///< a force below this is negligible
    int quietSteps = 4; ///< this many negligible steps in a row put a vertex to rest
    double stirringMm = 0.1; ///< a force beyond this makes the neighbours active
    int shares = 0; ///< number of parts for threads; 0: as many as are worthwhile
};

/// What one step did.
struct DeformationStep {
    std::size_t active = 0; ///< number of vertices that took part
    double greatestForceMm = 0.0; ///< of the sums of forces
    double greatestMoveMm = 0.0;
};

/// The motion of a surface: which vertices are active, and their speeds. Only active vertices cost
/// time.
///
/// A vertex that is not green becomes active on request, or when a large force acts on a neighbour.
/// It comes to rest after several steps with negligible forces, or on request. The result of a step
/// depends on mesh, forces and history, not on the number of threads.
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
    /// Sets the speeds of vertices to 0 that were stopped on their way.
    void stop(std::span<const VertexId> vertices);
    /// To be called after a change of structure. The given vertices are new or have other
    /// neighbours; they become active, with speed 0. Vertices that no longer exist are forgotten.
    void restructured(const SimplexMesh& mesh, std::span<const VertexId> vertices);

    /// The active vertices, ascending.
    [[nodiscard]] const std::vector<VertexId>& active() const { return m_active; }

    /// Moves the active vertices once; external forces are added.
    DeformationStep step(SimplexMeshEdit& edit, std::span<const ExternalForce* const> forces,
        SurfaceGuide* guide = nullptr);

private:
    struct Motion {
        glm::dvec3 speed{0.0};
        std::uint8_t quiet = 0; ///< number of steps with a negligible force
        bool isActive = false;
    };
    struct Pull {
        glm::dvec3 force{0.0};
        glm::dvec3 place{0.0};
    };

    void measureCurvatures(const SimplexMesh& mesh);
    /// The mean of the normals of a vertex and its neighbours.
    [[nodiscard]] glm::dvec3 evenNormal(const SimplexMesh& mesh, VertexId id) const;
    void forgetInactive();

    DeformationSettings m_settings;
    std::vector<VertexId> m_active;
    std::vector<Motion> m_motions; ///< by vertex
    // Working memory of a step:
    std::vector<VertexId> m_measured; ///< the active vertices, then those around them
    std::vector<std::uint32_t> m_stamps; ///< by vertex: the step in which it was measured
    std::uint32_t m_stamp = 0;
    std::vector<glm::dvec3> m_normals; ///< by vertex
    std::vector<double> m_curvatures; ///< by vertex
    std::vector<double> m_evened; ///< by vertex
    std::vector<double> m_distances; ///< mm to the neighbours, by index in m_active
    std::vector<Pull> m_pulls; ///< by index in m_active
};

} // namespace core
