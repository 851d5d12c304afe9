// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/HeldShrink.h"

#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/growth/GrowthProgress.h"
#include "core/session/EditSession.h"
#include "ui/base/StudyTexts.h"
#include "ui/workspace/Workspace.h"

#include <algorithm>

namespace ui {

namespace {

/// A hand must be able to stop where it wants, also where growth runs at full speed.
constexpr double usualPace = 8.0; // generations per second
constexpr double fastestPace = 20.0;

} // namespace

HeldShrink::HeldShrink(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&m_pace, &QTimer::timeout, this, &HeldShrink::goOn);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_on = false;
        m_pace.stop();
    });
}

bool HeldShrink::begin(const std::vector<glm::ivec3>& voxels)
{
    core::EditSession* session = m_workspace.session();
    if (!session || m_on)
        return false;
    core::ShrinkAt shrink{.steps = 1, .plane = core::namedPlane(m_workspace.growthPlane())};
    for (const glm::ivec3& voxel : voxels)
        shrink.pointsLps.push_back(m_workspace.volume()->geometry.toWorld(glm::dvec3(voxel)));
    if (const auto begun = session->begin(shrink); !begun) {
        m_workspace.fail(begun.error());
        return false;
    }
    m_on = true;
    m_steps = 1;
    const double chosen = m_workspace.growSettings().generationsPerSecond;
    const double pace = chosen > 0.0 ? std::min(chosen, fastestPace) : usualPace;
    m_pace.start(int(1000.0 / pace));
    Q_EMIT changed();
    return true;
}

/// A step is asked for when the one before is seen: so it stops at once when the pen is lifted.
void HeldShrink::goOn()
{
    core::EditSession* session = open();
    if (!session || session->openIsRefused()) {
        m_pace.stop();
        Q_EMIT changed();
        return;
    }
    const auto progress = session->growthProgress().backwards;
    Q_EMIT changed();
    if (!progress)
        return;
    if (progress->bound != core::BackwardProgress::Bound::None)
        return m_pace.stop();
    if (int(progress->steps) >= m_steps)
        session->extend(core::ToSteps{++m_steps});
}

void HeldShrink::end(bool kept)
{
    if (!m_on)
        return;
    core::EditSession* session = open();
    m_on = false;
    m_pace.stop();
    if (session)
        session->end(kept ? core::Ending::Commit : core::Ending::Rollback);
    Q_EMIT changed();
}

bool HeldShrink::refused() const
{
    const core::EditSession* session = open();
    return session && session->openIsRefused();
}

core::EditSession* HeldShrink::open() const
{
    core::EditSession* session = m_workspace.session();
    return m_on && session && session->isOpen<core::ShrinkAt>() ? session : nullptr;
}

QString HeldShrink::words() const
{
    const core::EditSession* session = open();
    if (!session)
        return m_on ? tr("has become a step of the history") : QString();
    if (session->openIsRefused())
        return tr("takes nothing back by generations; lift the pen to cut it off");
    const auto progress = session->growthProgress().backwards;
    if (!progress)
        return tr("goes back …");
    using Bound = core::BackwardProgress::Bound;
    const QString volume = millilitreText(*m_workspace.volume(), progress->members);
    const QString taken = progress->steps == 1
        ? tr("1 generation back: takes %1").arg(volume)
        : tr("%1 generations back: takes %2").arg(progress->steps).arg(volume);
    switch (progress->bound) {
    case Bound::None:
        break;
    case Bound::Seeds:
        return tr("%1; the rest is nearer to the seeds").arg(taken);
    case Bound::Everything:
        return tr("%1; one more would take everything").arg(taken);
    }
    return taken;
}

} // namespace ui
