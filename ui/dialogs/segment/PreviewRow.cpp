// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/PreviewRow.h"

#include "core/document/Document.h"
#include "core/volume/Volume.h"
#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/segment/EditTrial.h"
#include "ui/dialogs/segment/PreviewBox.h"
#include "ui/workspace/Workspace.h"

#include <QDialog>
#include <QHBoxLayout>
#include <QLabel>

#include <cstdlib>

namespace ui {

PreviewRow::PreviewRow(Workspace& workspace, const QString& name, QDialog* dialog)
    : QWidget(dialog)
    , m_workspace(workspace)
    , m_trial(new EditTrial(workspace, EditTrial::Pace::AtRest, dialog))
    , m_now(new QLabel(this))
    , m_box(new PreviewBox(name, this))
{
    m_now->setObjectName(name + QStringLiteral("Now"));
    m_now->setFont(theme::smallFont());
    m_now->setProperty("role", QStringLiteral("secondary"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme::smallPadding);
    row->addWidget(m_now, 1);
    row->addWidget(m_box);
    connect(m_box, &QCheckBox::toggled, this, &PreviewRow::switched);
    connect(m_trial, &EditTrial::changed, this, &PreviewRow::changed);
}

void PreviewRow::preview(const std::optional<core::Edit>& edit)
{
    if (edit && m_box->isChecked() && m_workspace.session())
        m_trial->show(*edit);
    else
        m_trial->drop();
}

bool PreviewRow::handOver(const core::Edit& edit)
{
    return m_trial->handOver(edit);
}

void PreviewRow::showState(const core::Segment* segment)
{
    if (!segment)
        return m_now->clear();
    constexpr double mm3PerMl = 1000.0;
    const double mlPerVoxel = m_workspace.volume()->geometry.voxelVolumeMm3() / mm3PerMl;
    const auto sized = [mlPerVoxel](
                           std::int64_t voxels) { return volumeText(double(voxels) * mlPerVoxel); };
    const QString now = sized(segment->voxels);
    if (const std::optional<std::int64_t> voxels = m_trial->voxels()) {
        const std::int64_t more = *voxels - segment->voxels;
        m_now->setText(more == 0
                ? tr("Preview: %1, as large as now").arg(now)
                : tr("Preview: %1 → %2 (%3%4)")
                      .arg(now, sized(*voxels), more > 0 ? QStringLiteral("+") : QString(minusSign),
                          sized(std::abs(more))));
    } else if (m_trial->isCounting()) {
        m_now->setText(tr("Preview: %1 → …").arg(now));
    } else {
        m_now->setText(tr("Now: %1").arg(now));
    }
}

} // namespace ui
