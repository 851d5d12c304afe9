// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/SurfaceState.h"

#include "core/refine/mesh/SurfaceDelta.h"

#include <utility>

namespace core {

namespace {

WrittenParts writtenBy(const SimplexMeshDelta& delta)
{
    WrittenParts written;
    for (const SimplexMeshDelta::VertexChange& vertex : delta.vertices)
        written.vertices.push_back(vertex.id);
    for (const SimplexMeshDelta::FaceChange& face : delta.faces)
        written.faces.push_back(face.id);
    return written;
}

} // namespace

SurfaceStep::Target SurfaceState::followed() const
{
    if (!target)
        return {};
    return {.voxels = target->voxels(), .faceAreaMm2 = target->faceAreaMm2()};
}

std::shared_ptr<const SurfaceStep> SurfaceState::step(RowId row) const
{
    const auto known = m_steps.find(row);
    return known == m_steps.end() ? nullptr : known->second;
}

void SurfaceState::keep(RowId row, std::shared_ptr<const SurfaceStep> step)
{
    m_steps[row] = std::move(step);
}

void SurfaceState::moveOver(RowId row, bool back)
{
    if (const auto known = m_steps.find(row); known != m_steps.end())
        move(*known->second, back);
}

void SurfaceState::move(const SurfaceStep& step, bool back)
{
    // A forged session: the hash of the state will not agree.
    if (back ? !canUndo(step.mesh, mesh) : !canRedo(step.mesh, mesh))
        return;
    if (back)
        step.mesh.undo(mesh);
    else
        step.mesh.redo(mesh);
    sha256 = back ? step.sha256Before : step.sha256After;
    if (step.target) {
        const SurfaceStep::Target& now = back ? step.target->before : step.target->after;
        target = now.voxels.empty()
            ? nullptr
            : std::make_shared<const SurfaceTarget>(now.voxels, m_geometry, now.faceAreaMm2);
    }
    if (m_listener)
        m_listener(updateOf(mesh, writtenBy(step.mesh)));
}

bool SurfaceState::isIntact() const
{
    return sha256.isEmpty() ? mesh.vertexSlots() == 0 : sha256Of(mesh) == sha256;
}

void SurfaceState::show(SurfaceUpdate update) const
{
    if (m_listener)
        m_listener(std::move(update));
}

void SurfaceState::showAll(bool isThere) const
{
    if (m_listener)
        m_listener(isThere ? wholeUpdate(mesh) : SurfaceUpdate{.isWhole = true});
}

} // namespace core
