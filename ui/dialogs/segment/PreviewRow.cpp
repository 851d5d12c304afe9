// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/PreviewRow.h"

#include "core/document/Document.h"
#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/segment/EditTrial.h"
#include "ui/dialogs/segment/PreviewBox.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QLabel>

#include <cstdlib>

namespace ui {

namespace {

QString sizeText(const Workspace& workspace, std::int64_t voxels)
{
    return volumeText(*workspace.volume(), voxels);
}

/// "+": there are more of them than before.
QString signOf(std::int64_t more)
{
    return more > 0 ? QStringLiteral("+") : QString(minusSign);
}

} // namespace

PreviewRow::PreviewRow(Workspace& workspace, const QString& name, QWidget* owner, In place)
    : QWidget(owner)
    , m_workspace(workspace)
    , m_place(place)
    , m_trial(new EditTrial(workspace,
          place == In::Dialog ? EditTrial::Pace::AtRest : EditTrial::Pace::InPassing, owner))
    , m_now(new QLabel(this))
    , m_box(new PreviewBox(name, this, place == In::Dialog))
{
    m_now->setObjectName(name + QStringLiteral("Now"));
    m_now->setFont(theme::smallFont());
    m_now->setProperty("role", QStringLiteral("secondary"));
    if (place == In::Column) {
        m_now->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_now->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        m_now->setFixedHeight(2 * m_now->fontMetrics().lineSpacing()); // as with a preview
    }
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme::smallPadding);
    row->addWidget(m_now, 1);
    row->insertWidget(place == In::Dialog ? 1 : 0, m_box);
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

bool PreviewRow::isPreviewing() const
{
    return m_trial->isShown();
}

bool PreviewRow::handOver(const core::Edit& edit)
{
    return m_trial->handOver(edit);
}

void PreviewRow::showState(const core::Segment* segment)
{
    if (!segment)
        return m_now->clear();
    m_now->setText(m_place == In::Dialog ? stateText(*segment) : shortText(*segment));
}

QString PreviewRow::stateText(const core::Segment& segment) const
{
    const QString now = sizeText(m_workspace, segment.voxels);
    if (const std::optional<std::int64_t> voxels = m_trial->voxels()) {
        const std::int64_t more = *voxels - segment.voxels;
        if (more == 0)
            return tr("Preview: %1, as large as now").arg(now);
        return tr("Preview: %1 → %2 (%3%4)")
            .arg(now, sizeText(m_workspace, *voxels), signOf(more),
                sizeText(m_workspace, std::abs(more)));
    }
    return m_trial->isCounting() ? tr("Preview: %1 → …").arg(now) : tr("Now: %1").arg(now);
}

/// A few voxels are less than what millilitres show.
QString PreviewRow::shortText(const core::Segment& segment) const
{
    const QString now = sizeText(m_workspace, segment.voxels);
    if (const std::optional<std::int64_t> voxels = m_trial->voxels()) {
        const std::int64_t more = *voxels - segment.voxels;
        if (more == 0)
            return now + u'\n' + tr("stays as it is");
        const QString sized = tr("%1 → %2").arg(now, sizeText(m_workspace, *voxels));
        const QString counted = std::abs(more) == 1 ? tr("%1%2 voxel") : tr("%1%2 voxels");
        return sized + u'\n' + counted.arg(signOf(more), countText(std::abs(more)));
    }
    return m_trial->isCounting() ? tr("%1 → …").arg(now) : now;
}

} // namespace ui
