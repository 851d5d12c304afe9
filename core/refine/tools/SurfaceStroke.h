// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"
#include "core/refine/tools/SurfaceTool.h"

#include <memory>

namespace core {

class BoundaryForce;
class Progress;
struct VolumeGeometry;

/// Parameters of a stroke.
struct SurfaceStrokeSettings {
    /// Intended area of a face where the surface is flat, mm². It should be constant for the life
    /// of a surface, which would otherwise become finer with each stroke; 0: the mean of the mesh.
    double areaMm2 = 0.0;
    /// Yellow vertices that the tool moves become red, so that they stay where it put them.
    bool reddens = false;
    int restructureEvery = 5; ///< steps; 0: never
    int shares = 0; ///< number of parts for threads (DeformationSettings)
    /// If set, the surface never passes through itself, as judged on the lattice of this grid
    /// (SelfIntersections.h), and sphere and plane affect only the sheet under the pen. It must
    /// outlive the stroke. Null: the surface may pass through itself, as in older rows.
    const VolumeGeometry* apartOn = nullptr;
    /// Checked between the parts of a step for whether the stroke was cancelled. From then on
    /// nothing moves any more, and only rollback() makes sense. It must outlive the stroke; null:
    /// it is never cancelled.
    const Progress* progress = nullptr;
};

/// A stroke of a tool, from pen down to pen up, sample by sample: one transaction.
///
/// Tools move red and yellow vertices, never green ones (seed B §6.2). When the pen is lifted,
/// yellow vertices return to the boundary of the mask, and red ones stay where they were put. What
/// a tool touched is held there along the tool's normal and can only move sideways, for even faces.
/// What it did not touch is held in its place by a weak spring, so that a stroke changes nothing
/// far away.
///
/// The result depends only on mesh, mask, settings and samples, not on time or threads: between
/// samples the tool moves in steps shorter than an edge. One thread at a time. The cost of add()
/// grows with the distance that the pen moved.
class SurfaceStroke {
public:
    /// @param mesh must outlive this; nothing else may write it meanwhile
    /// @param boundary of the mask that yellow follows; must outlive this; null: yellow behaves
    /// like red
    SurfaceStroke(SimplexMesh& mesh, const BoundaryForce* boundary, const SurfaceTool& tool,
        const SurfaceStrokeSettings& settings = {});
    ~SurfaceStroke();
    SurfaceStroke(const SurfaceStroke&) = delete;
    SurfaceStroke& operator=(const SurfaceStroke&) = delete;

    /// Moves the pen to a place; the same place again lets time pass.
    void add(const SurfaceSample& sample);
    /// Lifts the pen: continues until the surface is at rest, or for some hundred steps.
    void settle();
    /// What must be drawn anew since the last call.
    [[nodiscard]] WrittenParts takeWritten();

    [[nodiscard]] std::size_t activeVertices() const;
    [[nodiscard]] int steps() const; ///< of deformation so far

    /// Settles the stroke if that was not done, and ends it. Only the destructor may be called
    /// afterwards. The destructor alone rolls back.
    SimplexMeshDelta commit();
    void rollback();

private:
    class Motion;
    std::unique_ptr<Motion> m_motion;
};

} // namespace core
