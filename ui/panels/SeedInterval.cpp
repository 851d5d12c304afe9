// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/SeedInterval.h"

#include "ui/SeedStatistics.h"
#include "ui/Theme.h"
#include "ui/Workspace.h"

#include <QLocale>
#include <QMenu>
#include <QPointer>

#include <algorithm>

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
    setStyleSheet(QStringLiteral(
        "QToolButton { padding: 4px 2px; } QToolButton::menu-indicator { image: none; }"));
    auto* menu = new QMenu(this);
    for (const double deviations : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0})
        menu->addAction(tr("mean ± %1 σ").arg(QLocale().toString(deviations)), this,
            [this, deviations] { take(deviations); });
    setMenu(menu);
    setEnabled(false);
}

void SeedInterval::forget()
{
    m_values.clear();
    setEnabled(false);
}

void SeedInterval::ask()
{
    core::EditSession* session = m_workspace.session();
    const int label = m_workspace.activeSegment();
    std::vector<glm::ivec3> voxels;
    if (session)
        voxels = seedVoxels(*session, label);
    if (voxels.empty()) {
        forget();
        Q_EMIT valuesChanged();
        return;
    }
    if (voxels.size() == m_values.size() && label == m_label)
        return;
    core::ProbeVoxels question;
    question.voxels = std::move(voxels);
    session->ask(std::move(question),
        [button = QPointer<SeedInterval>(this), label](const core::EngineResult& result) {
            if (!button || result.error || !button->m_workspace.volume())
                return;
            button->m_label = label;
            button->m_values.clear();
            const core::VoxelEncoding& encoding = button->m_workspace.volume()->encoding;
            for (const core::ProbedVoxel& probe : result.probes)
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
    GrowSettings settings = m_workspace.growSettings();
    settings.lower = std::max(seeds.mean - spread, volume->minimum);
    settings.upper = std::min(seeds.mean + spread, volume->maximum);
    m_workspace.setGrowSettings(settings);
    Q_EMIT intervalTaken();
}

QString SeedInterval::text(int seeds) const
{
    QString text = seeds == 1 ? tr("1 seed voxel") : tr("%1 seed voxels").arg(seeds);
    if (!m_values.empty() && m_workspace.volume()) {
        const SeedStatistics statistics = seedStatistics(m_values);
        text =
            tr("%1 · %2 ± %3 %4")
                .arg(text, QLocale().toString(statistics.mean, 'f', 1),
                    QLocale().toString(statistics.deviation, 'f', 1), m_workspace.volume()->unit);
    }
    return text.trimmed();
}

} // namespace ui
