// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMeshEdit.h"
#include "core/refine/tools/SurfaceTool.h"

#include <memory>

namespace core {

class BoundaryForce;

struct SurfaceStrokeSettings {
    /// That a face is to have where the surface is flat, mm². One for the life of a surface, or it
    /// grows finer from stroke to stroke; 0: the mean of the mesh.
    double areaMm2 = 0.0;
    /// Yellow vertices that the tool moves turn red, so that they stay where it put them.
    bool reddens = false;
    int restructureEvery = 5; ///< steps; 0: never
    int shares = 0; ///< into which the work is cut (DeformationSettings)
};

/// A stroke of a tool, from pen down to pen up, sample by sample: one transaction.
///
/// Tools move red and yellow vertices, green ones never (seed B §6.2). Where the pen is up, yellow
/// goes back to the boundary of the mask; red stays where it was put. What a tool touched is held
/// there along the tool's normal, and moves aside only, for even faces; what it did not touch is
/// held to its place by a weak spring, so that a stroke changes nothing far away.
///
/// What it does depends on mesh, mask, settings and samples alone, on neither time nor threads:
/// between samples the tool is walked in steps shorter than an edge. One thread at a time; add()
/// takes about as long as the pen went far.
class SurfaceStroke {
public:
    /// @param mesh must outlive it, and is written by nobody else meanwhile
    /// @param boundary of the mask that yellow follows, likewise; may be null: yellow is as red
    SurfaceStroke(SimplexMesh& mesh, const BoundaryForce* boundary, const SurfaceTool& tool,
        const SurfaceStrokeSettings& settings = {});
    ~SurfaceStroke();
    SurfaceStroke(const SurfaceStroke&) = delete;
    SurfaceStroke& operator=(const SurfaceStroke&) = delete;

    /// The pen is there; the same place again lets time pass.
    void add(const SurfaceSample& sample);
    /// The pen is up: until the surface is at rest, or some hundred steps are over.
    void settle();
    /// What has to be drawn anew since it was last asked.
    [[nodiscard]] WrittenParts takeWritten();

    [[nodiscard]] std::size_t activeVertices() const;
    [[nodiscard]] int steps() const; ///< of deformation so far

    /// Settles it, if that was not done. Nothing may be called afterwards but the destructor, which
    /// by itself rolls back.
    SimplexMeshDelta commit();
    void rollback();

private:
    class Motion;
    std::unique_ptr<Motion> m_motion;
};

} // namespace core
