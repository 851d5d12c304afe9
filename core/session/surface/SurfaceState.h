// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "core/refine/mesh/SurfaceUpdate.h"
#include "core/session/surface/SurfaceStep.h"
#include "core/session/surface/SurfaceTarget.h"

#include <functional>
#include <map>
#include <memory>

namespace core {

/// The surface that is being refined, as it is at the position of the history, and what each row
/// changed of it. Part of SessionState. Belongs to the session's thread, but to the side thread
/// while an operation has that deform it.
class SurfaceState {
public:
    using Listener = std::function<void(SurfaceUpdate)>;

    SimplexMesh mesh;
    /// The mask that yellow parts follow; null: there is no surface.
    std::shared_ptr<const SurfaceTarget> target;
    QByteArray sha256; ///< of the mesh, hex; empty: there is none

    void setGeometry(const VolumeGeometry& geometry) { m_geometry = geometry; }
    [[nodiscard]] const VolumeGeometry& geometry() const { return m_geometry; }

    [[nodiscard]] SurfaceStep::Target followed() const;
    /// What a row changed; null: nothing.
    [[nodiscard]] std::shared_ptr<const SurfaceStep> step(RowId row) const;

    /// What a row changed that was carried out: mesh, target and hash are as it left them.
    void keep(RowId row, std::shared_ptr<const SurfaceStep> step);
    /// Goes over a row, if it is one that changed the surface.
    void moveOver(RowId row, bool back);

    /// The mesh is the one that has the hash. What was thrown in the middle of changing it shows
    /// here.
    [[nodiscard]] bool isIntact() const;

    /// Told what is to be drawn anew, on the thread that the surface belongs to then.
    void setListener(Listener listener) { m_listener = std::move(listener); }
    void show(SurfaceUpdate update) const;
    /// Shown is nothing but what there is; @param isThere whether that is anything
    void showAll(bool isThere) const;

private:
    VolumeGeometry m_geometry;
    std::map<RowId, std::shared_ptr<const SurfaceStep>> m_steps;
    Listener m_listener;
};

} // namespace core
