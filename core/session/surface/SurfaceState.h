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

/// The surface that is refined, at the position of the history, and what each row changed of it.
/// Part of SessionState. It belongs to the session's thread, or to the side thread while an
/// operation deforms it there.
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

    /// Keeps what a row changed that was carried out; mesh, target and hash already are in the
    /// state after it.
    void keep(RowId row, std::shared_ptr<const SurfaceStep> step);
    /// Applies a row, or takes it back, if it changed the surface.
    void moveOver(RowId row, bool back);
    /// Takes back what was carried out last and is to be no row.
    void takeBack(const SurfaceStep& step) { move(step, true); }

    /// Whether the mesh has the hash. It has not if an exception interrupted a change.
    [[nodiscard]] bool isIntact() const;

    /// @param listener told what must be drawn anew, on the thread to which the surface then
    /// belongs
    void setListener(Listener listener) { m_listener = std::move(listener); }
    void show(SurfaceUpdate update) const;
    /// Has everything drawn anew. @param isThere whether there is a surface
    void showAll(bool isThere) const;

private:
    void move(const SurfaceStep& step, bool back);

    VolumeGeometry m_geometry;
    std::map<RowId, std::shared_ptr<const SurfaceStep>> m_steps;
    Listener m_listener;
};

} // namespace core
