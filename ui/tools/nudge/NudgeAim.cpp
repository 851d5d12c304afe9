// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/nudge/NudgeAim.h"

#include "core/edits/engine/NudgeDisc.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <utility>
#include <vector>

namespace ui {

/// Used by one thread at a time: the other one while it looks, else the window's.
struct NudgeAim::Job {
    core::NudgeDisc disc{};
    core::BrickGrid grid{};
    std::uint8_t label = 0;
    Answer answer{};
    std::vector<core::BrickImage> near{};
};

NudgeAim::NudgeAim(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionClosing, this, &NudgeAim::drop);
}

void NudgeAim::drop()
{
    m_background.cancel();
    m_job.reset();
}

core::Result<void> NudgeAim::ask(const core::BrushPath& path, int segment, Answer answer)
{
    drop();
    core::EditSession& session = *m_workspace.session();
    const core::Segment* its = session.document().segment(segment);
    if (!its)
        return core::failure(core::ErrorCode::UnknownSegment, QString::number(segment));
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    core::Result<core::NudgeDisc> disc = core::nudgeDisc(path, geometry, QStringLiteral("paint"));
    if (!disc)
        return tl::unexpected(disc.error());
    m_job = std::make_shared<Job>();
    m_job->disc = *std::move(disc);
    m_job->grid.volumeSize = geometry.size;
    m_job->label = std::uint8_t(its->label);
    m_job->answer = std::move(answer);
    std::vector<core::BrickKey> keys;
    for (const std::uint32_t brick : m_job->disc.bricks)
        keys.push_back({core::Field::Labels, its->plane, brick});
    session.questions().bricks(std::move(keys),
        [self = QPointer(this), job = m_job](core::Result<std::vector<core::BrickImage>> bricks) {
            if (!self || self->m_job != job)
                return;
            if (!bricks)
                return self->finish(tl::unexpected(bricks.error()));
            job->near = *std::move(bricks);
            self->look(job);
        });
    return {};
}

void NudgeAim::look(const std::shared_ptr<Job>& job)
{
    const auto look = [job] {
        return core::nudgeStart(
            job->disc.frame, job->disc.centre, job->grid, job->label, job->near);
    };
    m_background.start(
        this, look, [this](const core::Result<core::NudgeStart>& start) { finish(start); });
}

void NudgeAim::finish(const core::Result<core::NudgeStart>& start)
{
    const std::shared_ptr<Job> job = std::exchange(m_job, nullptr);
    if (job)
        job->answer(start);
}

} // namespace ui
