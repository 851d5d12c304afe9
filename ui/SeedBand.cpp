// SPDX-License-Identifier: Apache-2.0
#include "ui/SeedBand.h"

#include "ui/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <cmath>

namespace ui {

SeedBand::SeedBand(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_waiting = false; // the old session answers no more
        set({});
        ask();
    });
    connect(&workspace, &Workspace::growSettingsChanged, this, &SeedBand::ask);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &SeedBand::ask);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History)
                ask();
        });
}

void SeedBand::set(const std::optional<std::pair<double, double>>& values)
{
    if (values == m_values)
        return;
    m_values = values;
    Q_EMIT changed();
}

void SeedBand::ask()
{
    core::EditSession* session = m_workspace.session();
    const core::Volume* volume = m_workspace.volume();
    const GrowSettings& settings = m_workspace.growSettings();
    if (!session || !volume || !settings.sigmas.on) {
        set({});
        return;
    }
    m_stale = m_waiting;
    if (m_waiting)
        return;
    m_waiting = true;
    core::ProbeSeeds question;
    question.lowCode = volume->encoding.lowestCodeAtLeast(settings.lower);
    question.highCode = volume->encoding.highestCodeAtMost(settings.upper);
    session->ask(question,
        [band = QPointer<SeedBand>(this), session, question](const core::EngineResult& result) {
            if (!band || band->m_workspace.session() != session)
                return;
            band->m_waiting = false;
            if (band->m_stale) {
                band->ask();
                return;
            }
            const GrowSettings& now = band->m_workspace.growSettings();
            const core::VoxelEncoding& encoding = band->m_workspace.volume()->encoding;
            std::optional<std::pair<double, double>> values;
            for (const core::ProbedSeeds& seeds : result.seeds) {
                if (int(seeds.label) != band->m_workspace.activeSegment() || !now.sigmas.on)
                    continue;
                const core::CodeInterval codes =
                    core::seedInterval(seeds.sums, int(std::lround(now.sigmas.value * 256.0)));
                values = {encoding.value(std::max(codes.low, question.lowCode)),
                    encoding.value(std::min(codes.high, question.highCode))};
            }
            band->set(values);
        });
}

} // namespace ui
