// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/SurfacePreview.h"

#include "core/session/questions/VoxelQuestions.h"
#include "ui/tools/aim/DrillSurface.h"
#include "ui/tools/aim/PickQuestion.h"

#include <utility>

namespace ui {

SurfacePreview::SurfacePreview(Workspace& workspace, std::function<void()> changed)
    : m_workspace(workspace)
    , m_changed(std::move(changed))
{
}

void SurfacePreview::lookAt(const ViewContext& view, std::vector<glm::dvec2> outlineMm, int across)
{
    Wish wish{std::get<gpu::VolumeScene>(view.scene), std::move(outlineMm), across};
    if (m_asking)
        m_next = std::move(wish);
    else
        ask(std::move(wish));
}

void SurfacePreview::forget()
{
    m_asking.reset();
    m_next.reset();
    m_patch.reset();
}

void SurfacePreview::ask(Wish wish)
{
    core::EditSession* session = m_workspace.session();
    if (!session || wish.outlineMm.size() < 3)
        return;
    SurfacePatch patch(orthographicView(wish.scene), wish.outlineMm, wish.across);
    const core::Volume& volume = *m_workspace.volume();
    core::PickQuestion question = patch.question(
        volume, drillThreshold(m_workspace.volumeDisplay(), volume), wish.scene.clip);
    m_asking = std::make_shared<int>(0);
    session->questions().pick(std::move(question),
        [this, asked = std::weak_ptr<int>(m_asking), patch = std::move(patch)](
            const core::Result<PickedVoxels>& picked) mutable {
            if (asked.expired())
                return;
            m_asking.reset();
            if (picked) {
                patch.take(*m_workspace.volume(), *picked);
                m_patch = std::move(patch);
                m_changed();
            }
            if (m_next)
                ask(*std::exchange(m_next, std::nullopt));
        });
}

} // namespace ui
