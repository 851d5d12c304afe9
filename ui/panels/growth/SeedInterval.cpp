// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/SeedInterval.h"

#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/settings/SeedValues.h"
#include "ui/workspace/Workspace.h"

#include <QLocale>
#include <QMenu>
#include <QPointer>

#include <algorithm>
#include <cmath>

namespace ui {

SeedInterval::SeedInterval(Workspace& workspace, QWidget* parent)
    : QToolButton(parent)
    , m_workspace(workspace)
{
    setObjectName(QStringLiteral("intervalFromSeeds"));
    setFont(theme::smallFont());
    setText(tr("From seeds"));
    setToolTip(tr("Set the interval around the mean of the values under the seeds"));
    setPopupMode(QToolButton::InstantPopup);
    setFixedHeight(theme::controlHeight);
    auto* menu = new QMenu(this);
    for (const double deviations : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0})
        menu->addAction(tr("mean ± %1 σ").arg(QLocale().toString(deviations)), this,
            [this, deviations] { take(deviations); });
    setMenu(menu);
    setEnabled(false);
}

void SeedInterval::forget()
{
    ++m_asked;
    m_voxels.clear();
    m_values.clear();
    setEnabled(false);
}

void SeedInterval::ask()
{
    core::EditSession* session = m_workspace.session();
    std::vector<glm::ivec3> voxels;
    if (session)
        voxels = seedVoxels(*session, m_workspace.activeSegment());
    if (voxels == m_voxels)
        return;
    forget();
    Q_EMIT valuesChanged();
    if (voxels.empty())
        return;
    m_voxels = voxels;
    session->questions().probe(std::move(voxels),
        [button = QPointer<SeedInterval>(this), asked = m_asked](
            const core::Result<std::vector<core::ProbedVoxel>>& probes) {
            if (!button || button->m_asked != asked || !probes)
                return;
            const core::VoxelEncoding& encoding = button->m_workspace.volume()->encoding;
            for (const core::ProbedVoxel& probe : *probes)
                button->m_values.push_back(encoding.value(probe.code));
            button->setEnabled(!button->m_values.empty());
            Q_EMIT button->valuesChanged();
        });
}

void SeedInterval::take(double deviations)
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume || m_values.empty())
        return;
    const SeedStatistics seeds = seedStatistics(m_values);
    // One seed, or seeds of one value, have no spread to go by: take a hundredth of the range.
    const double spread = seeds.deviation > 0.0 ? deviations * seeds.deviation
                                                : 0.01 * (volume->maximum - volume->minimum);
    // Outwards to numbers with few digits: history and report name them.
    const double step = std::pow(10.0, std::floor(std::log10(spread / 50.0)));
    GrowSettings settings = m_workspace.growSettings();
    settings.lower = std::max(std::floor((seeds.mean - spread) / step) * step, volume->minimum);
    settings.upper = std::min(std::ceil((seeds.mean + spread) / step) * step, volume->maximum);
    m_workspace.setGrowSettings(settings);
    Q_EMIT intervalTaken();
}

QString SeedInterval::text(int seeds) const
{
    if (m_voxels.empty())
        return seeds == 1 ? tr("1 seed voxel, of another segment")
                          : tr("%1 seed voxels, all of other segments").arg(seeds);
    const QString count =
        m_voxels.size() == 1 ? tr("1 seed voxel") : tr("%1 seed voxels").arg(m_voxels.size());
    if (m_values.empty())
        return count;
    const SeedStatistics statistics = seedStatistics(m_values);
    return tr("%1 · %2 ± %3 %4")
        .arg(count, numberText(statistics.mean, 1), numberText(statistics.deviation, 1),
            m_workspace.volume()->unit)
        .trimmed();
}

} // namespace ui
