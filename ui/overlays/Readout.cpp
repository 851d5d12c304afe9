// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/Readout.h"

#include "core/session/questions/SegmentsAt.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/StudyTexts.h"

#include <QPointer>

namespace ui {

Readout::Readout(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::pointedLpsChanged, this, &Readout::look);
    connect(&workspace, &Workspace::crosshairChanged, this, &Readout::look);
    connect(&workspace, &Workspace::documentChanged, this, &Readout::look);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_asking = false; // a session takes its questions with it
        m_voxel = glm::ivec3(-1);
        look();
    });
}

void Readout::look()
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return show({});
    m_lps = m_workspace.pointedLps().value_or(m_workspace.crosshairLps());
    const glm::ivec3 voxel(glm::round(volume->geometry.toIndex(m_lps)));
    if (!volume->geometry.contains(voxel)) {
        m_voxel = voxel;
        return show(positionText(m_lps) + tr(" · outside the volume"));
    }
    m_voxel = voxel;
    if (m_asking) {
        m_stale = true;
        return;
    }
    m_asking = true;
    m_stale = false;
    m_workspace.session()->questions().probe({voxel},
        [self = QPointer(this), voxel](const core::Result<std::vector<core::ProbedVoxel>>& probes) {
            if (self)
                self->answer(voxel, probes && !probes->empty() ? &probes->front() : nullptr);
        });
}

void Readout::answer(const glm::ivec3& voxel, const core::ProbedVoxel* probe)
{
    m_asking = false;
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return;
    if (voxel == m_voxel && probe) {
        QString text = positionText(m_lps)
            + tr(" · voxel %1, %2, %3 · ").arg(voxel.x).arg(voxel.y).arg(voxel.z)
            + valueText(volume->encoding.value(probe->code), volume->unit,
                volume->maximum - volume->minimum);
        QStringList names;
        for (const core::Segment* segment :
            core::segmentsAt(m_workspace.session()->document(), *probe))
            names += segment->name;
        if (!names.empty())
            text += QStringLiteral(" · ") + names.join(QStringLiteral(", "));
        if (probe->tolerance)
            text += tr(" · joins at ") + toleranceText(*probe->tolerance, *volume);
        show(text);
    }
    if (m_stale)
        look();
}

void Readout::show(const QString& text)
{
    if (text == m_text)
        return;
    m_text = text;
    Q_EMIT textChanged();
}

} // namespace ui
