// SPDX-License-Identifier: Apache-2.0
#include "ui/views/SeenReadout.h"

#include "ui/tools/aim/SeenVoxels.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <utility>

namespace ui {

SeenReadout::SeenReadout(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_asking = false; // a session takes its questions with it
        leave();
    });
}

void SeenReadout::pointAt(const gpu::VolumeScene& scene, const glm::dvec2& planeMm)
{
    // Rays of a perspective view differ in direction; no tool works there either.
    if (!m_workspace.session() || !scene.orthographic)
        return;
    if (m_asking)
        m_next = Place{scene, planeMm};
    else
        ask({scene, planeMm});
}

void SeenReadout::leave()
{
    m_next.reset();
    ++m_asked;
}

void SeenReadout::ask(const Place& place)
{
    m_asking = true;
    const int asked = ++m_asked;
    askWhatIsPointedAt(m_workspace, place.scene, {place.planeMm},
        [self = QPointer(this), asked](const core::Result<SeenVoxels>& seen) {
            if (!self)
                return;
            self->m_asking = false;
            const core::Volume* volume = self->m_workspace.volume();
            if (asked == self->m_asked && volume && seen) {
                std::optional<glm::dvec3> lps;
                if (!seen->empty() && seen->front())
                    lps = volume->geometry.toWorld(glm::dvec3(seen->front()->voxel));
                self->m_workspace.setPointedLps(lps);
            }
            if (const auto next = std::exchange(self->m_next, std::nullopt))
                self->ask(*next);
        });
}

} // namespace ui
