// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/ShrinkPreview.h"

#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/StudyTexts.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

namespace ui {

namespace {

constexpr int againMilliseconds = 8;

} // namespace

ShrinkPreview::ShrinkPreview(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_again.setSingleShot(true);
    m_again.setInterval(againMilliseconds);
    connect(&m_again, &QTimer::timeout, this, &ShrinkPreview::ask);
}

void ShrinkPreview::begin(bool onlyHere)
{
    end();
    m_on = true;
    m_onlyHere = onlyHere;
}

void ShrinkPreview::end()
{
    if (!m_on)
        return;
    m_on = false;
    m_asking = false;
    ++m_sketch;
    m_again.stop();
    m_wanted.clear();
    m_answered = 0;
    m_cutPreview.reset();
    m_refused.reset();
    if (core::EditSession* session = m_workspace.session())
        session->questions().dropCutPreview();
    Q_EMIT changed();
}

void ShrinkPreview::follow(const std::vector<glm::ivec3>& voxels)
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

void ShrinkPreview::ask()
{
    core::EditSession* session = m_workspace.session();
    if (!m_on || !session || m_asked == 0)
        return;
    // As the commit will name them.
    core::ShrinkAt shrink{
        .onlyHere = m_onlyHere, .plane = core::namedPlane(m_workspace.growthPlane())};
    for (std::size_t i = 0; i < m_asked; ++i)
        shrink.pointsLps.push_back(m_workspace.volume()->geometry.toWorld(glm::dvec3(m_wanted[i])));
    const core::Result<void> asked = session->questions().previewCut(shrink,
        [preview = QPointer<ShrinkPreview>(this), sketch = m_sketch](
            const core::Result<std::optional<core::CutPreview>>& cutPreview) {
            if (preview && preview->m_sketch == sketch)
                preview->take(cutPreview);
        });
    m_asking = asked.has_value(); // if not, the commit will say why
}

void ShrinkPreview::take(const core::Result<std::optional<core::CutPreview>>& cutPreview)
{
    if (cutPreview && !*cutPreview)
        return m_again.start();
    m_asking = false;
    m_refused.reset();
    m_cutPreview = core::CutPreview{};
    m_answered = m_asked;
    if (!cutPreview)
        m_refused = cutPreview.error();
    else
        m_cutPreview = {.members = (*cutPreview)->members, .voxels = (*cutPreview)->voxels};
    if (m_asked < m_wanted.size()) {
        m_asked = m_wanted.size();
        ask();
    }
    Q_EMIT changed();
}

QString ShrinkPreview::words() const
{
    if (!m_on || m_wanted.empty())
        return {};
    if (!m_cutPreview)
        return tr("looks what it takes …");
    QString words = tr("nothing grown here");
    if (m_refused && m_refused->code == core::ErrorCode::SeedsStay) {
        words = tr("takes nothing: there are seeds under the sketch");
    } else if (m_cutPreview->members > 0) {
        const QString volume = millilitreText(*m_workspace.volume(), m_cutPreview->voxels);
        words = m_onlyHere ? tr("takes only this: %1").arg(volume) : tr("takes %1").arg(volume);
    }
    return upToDate() ? words : words + QStringLiteral(" …");
}

std::optional<std::int64_t> ShrinkPreview::voxels() const
{
    return m_cutPreview ? std::optional(m_cutPreview->voxels) : std::nullopt;
}

} // namespace ui
