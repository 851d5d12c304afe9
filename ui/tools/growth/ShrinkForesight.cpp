// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/ShrinkForesight.h"

#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/models/SegmentListModel.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

namespace ui {

namespace {

constexpr int againMilliseconds = 8;

} // namespace

ShrinkForesight::ShrinkForesight(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_again.setSingleShot(true);
    m_again.setInterval(againMilliseconds);
    connect(&m_again, &QTimer::timeout, this, &ShrinkForesight::ask);
}

void ShrinkForesight::begin(bool onlyHere)
{
    end();
    m_on = true;
    m_onlyHere = onlyHere;
}

void ShrinkForesight::end()
{
    if (!m_on)
        return;
    m_on = false;
    m_asking = false;
    ++m_sketch;
    m_again.stop();
    m_wanted.clear();
    m_answered = 0;
    m_foreseen.reset();
    m_refused.reset();
    if (core::EditSession* session = m_workspace.session())
        session->questions().dropForesight();
    Q_EMIT changed();
}

void ShrinkForesight::follow(const std::vector<glm::ivec3>& voxels)
{
    if (!m_on)
        return;
    m_wanted = voxels;
    if (!m_asking) {
        m_asked = m_wanted.size();
        ask();
    }
    Q_EMIT changed();
}

void ShrinkForesight::ask()
{
    core::EditSession* session = m_workspace.session();
    if (!m_on || !session || m_asked == 0)
        return;
    // As the commit will name them.
    core::ShrinkAt shrink{.onlyHere = m_onlyHere};
    for (std::size_t i = 0; i < m_asked; ++i)
        shrink.pointsLps.push_back(m_workspace.volume()->geometry.toWorld(glm::dvec3(m_wanted[i])));
    const core::Result<void> asked = session->questions().foreseeCut(shrink,
        [foresight = QPointer<ShrinkForesight>(this), sketch = m_sketch](
            const core::Result<std::optional<core::ForeseenCut>>& foreseen) {
            if (foresight && foresight->m_sketch == sketch)
                foresight->take(foreseen);
        });
    m_asking = asked.has_value(); // if not, the commit will say why
}

void ShrinkForesight::take(const core::Result<std::optional<core::ForeseenCut>>& foreseen)
{
    if (foreseen && !*foreseen)
        return m_again.start();
    m_asking = false;
    m_refused.reset();
    m_foreseen = core::ForeseenCut{};
    m_answered = m_asked;
    if (!foreseen)
        m_refused = foreseen.error();
    else
        m_foreseen = {.members = (*foreseen)->members, .voxels = (*foreseen)->voxels};
    if (m_asked < m_wanted.size()) {
        m_asked = m_wanted.size();
        ask();
    }
    Q_EMIT changed();
}

QString ShrinkForesight::words() const
{
    if (!m_on || m_wanted.empty())
        return {};
    if (!m_foreseen)
        return tr("looks what it takes …");
    QString words = tr("nothing grown here");
    if (m_refused && m_refused->code == core::ErrorCode::SeedsStay) {
        words = tr("takes nothing: there are seeds under the sketch");
    } else if (m_foreseen->members > 0) {
        const QString volume =
            millilitreText(m_foreseen->voxels, m_workspace.volume()->geometry.voxelVolumeMm3());
        words = m_onlyHere ? tr("takes only this: %1").arg(volume) : tr("takes %1").arg(volume);
    }
    return upToDate() ? words : words + QStringLiteral(" …");
}

std::optional<std::int64_t> ShrinkForesight::voxels() const
{
    return m_foreseen ? std::optional(m_foreseen->voxels) : std::nullopt;
}

} // namespace ui
