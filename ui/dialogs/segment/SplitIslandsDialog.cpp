// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/SplitIslandsDialog.h"

#include "core/islands/SegmentIslands.h"
#include "core/session/EditSession.h"
#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/segment/PreviewRow.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

SplitIslandsDialog::SplitIslandsDialog(Workspace& workspace, QWidget* parent)
    : LabelLookDialog(workspace, tr("Split islands into segments"), QStringLiteral("split"), parent)
    , m_mm3(new NumberField(this))
    , m_result(new QLabel(this))
    , m_preview(new PreviewRow(workspace, QStringLiteral("split"), this))
    , m_apply(new QPushButton(tr("Split"), this))
{
    constexpr double mostMm3 = 1e7; // ten litres
    m_mm3->setObjectName(QStringLiteral("splitMm3"));
    m_mm3->setAccessibleName(tr("The smallest island that becomes a segment"));
    m_mm3->setRange(0.0, mostMm3);
    m_mm3->setDecimals(1);
    m_mm3->setSingleStep(10.0);
    m_mm3->setSuffix(tr(" mm³"));
    m_mm3->setSpecialValueText(tr("any size"));
    m_mm3->setAlignment(Qt::AlignRight);
    auto* name = new QLabel(tr("Islands become segments from"), this);
    name->setBuddy(m_mm3);
    auto* size = new QHBoxLayout;
    size->setSpacing(theme::smallPadding);
    size->addWidget(name, 1);
    size->addWidget(m_mm3);
    auto* hint = new QLabel(
        tr("The largest island stays the segment's, and so do smaller ones than that."), this);
    hint->setFont(theme::smallFont());
    hint->setProperty("role", QStringLiteral("secondary"));
    m_result->setObjectName(QStringLiteral("splitResult"));
    m_result->setFont(theme::smallFont());
    m_apply->setObjectName(QStringLiteral("applySplit"));
    m_apply->setDefault(true);
    auto* close = new QPushButton(tr("Close"), this);
    close->setAutoDefault(false);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(theme::smallPadding);
    buttons->addStretch(1);
    buttons->addWidget(m_apply);
    buttons->addWidget(close);
    column().addLayout(size);
    column().addWidget(hint);
    column().addWidget(m_result);
    addEditable();
    column().addSpacing(theme::smallPadding);
    column().addWidget(m_preview);
    column().addLayout(buttons);
    connect(m_mm3, &QDoubleSpinBox::valueChanged, this, &SplitIslandsDialog::follow);
    connect(&workspace, &Workspace::editableChanged, this, &SplitIslandsDialog::follow);
    connect(m_preview, &PreviewRow::switched, this, &SplitIslandsDialog::follow);
    connect(m_preview, &PreviewRow::changed, this, &SplitIslandsDialog::showState);
    // Pictures have the colours of the new segments, too.
    connect(m_preview, &PreviewRow::changed, &workspace, &Workspace::viewOptionsChanged);
    connect(m_apply, &QPushButton::clicked, this, &SplitIslandsDialog::carryOut);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
}

void SplitIslandsDialog::ask(int label)
{
    const core::EditSession* session = workspace().session();
    const core::Segment* about = session ? session->document().segment(label) : nullptr;
    if (!about)
        return;
    setLabel(label);
    m_mm3->setValue(smallIslandMm3(workspace(), *about));
    bringUp();
    m_mm3->setFocus();
    m_mm3->selectAll();
    look();
}

void SplitIslandsDialog::count(const LabelFetch::Planes& planes)
{
    lookThrough(
        [planes, size = workspace().volume()->geometry.size, label = std::uint8_t(label())](
            const core::Progress& progress) {
            return core::islandSizes(planes->front().labels, size, label, progress);
        },
        [this](const std::vector<std::int64_t>& sizes) {
            m_sizes = sizes;
            follow();
        });
}

core::SplitIslands SplitIslandsDialog::chosen() const
{
    core::SplitIslands edit{.segment = label(), .editable = workspace().editableRange()};
    if (const double mm3 = m_mm3->value(); mm3 > 0.0)
        edit.mm3 = mm3;
    return edit;
}

std::optional<std::int64_t> SplitIslandsDialog::others() const
{
    if (!m_sizes)
        return std::nullopt;
    const std::int64_t least = core::leastVoxels(chosen(), workspace().volume()->geometry);
    const auto large = std::count_if(
        m_sizes->begin(), m_sizes->end(), [least](std::int64_t voxels) { return voxels >= least; });
    return std::max<std::int64_t>(0, large - 1); // the largest stays, however small it is
}

core::SplitIslands SplitIslandsDialog::previewed() const
{
    core::SplitIslands edit = chosen();
    const core::Segment* about = segment();
    const std::int64_t made = others().value_or(0);
    if (about && made > 0 && !edit.editable)
        edit.into = core::usualParts(workspace().session()->document(), *about, std::size_t(made));
    return edit;
}

void SplitIslandsDialog::showState()
{
    LabelLookDialog::showState();
    const core::Segment* about = segment();
    QString why = whyUnchangeable(about);
    QString result = isLooking() ? tr("Looking …") : QString();
    if (about && m_sizes) {
        const std::int64_t others = *this->others();
        // Which of them have voxels that may change is only known when they are split.
        const bool isLimited = !workspace().editableText().isEmpty();
        const auto room = std::int64_t(core::roomForSegments(workspace().session()->document()));
        if (others == 0)
            result = tr("No island beside the largest is so large");
        else if (isLimited)
            result = tr("Up to %1 of %2 islands become segments: those with voxels that may change")
                         .arg(countText(others), countText(m_sizes->size()));
        else if (others > room)
            result = tr("%1 islands are so large, but there can be only %2 segments more")
                         .arg(countText(others), countText(room));
        else if (others == 1)
            result = tr("1 of %1 islands becomes a segment").arg(countText(m_sizes->size()));
        else
            result = tr("%1 of %2 islands become segments")
                         .arg(countText(others), countText(m_sizes->size()));
        if (why.isEmpty() && (others == 0 || (others > room && !isLimited)))
            why = result;
    }
    m_result->setText(result);
    m_apply->setEnabled(why.isEmpty());
    m_apply->setToolTip(why);
    m_preview->showState(about);
}

void SplitIslandsDialog::forgetFound()
{
    m_sizes.reset();
    m_preview->preview(std::nullopt); // what is looked at next is the segment without it
}

void SplitIslandsDialog::follow()
{
    showState();
    const bool isWanted = isVisible() && m_sizes && m_apply->isEnabled();
    m_preview->preview(isWanted ? std::optional<core::Edit>(previewed()) : std::nullopt);
}

void SplitIslandsDialog::carryOut()
{
    const core::SplitIslands seen = previewed();
    const bool isOpen = m_preview->handOver(seen);
    splitIslands(workspace(), isOpen ? seen : chosen(), isOpen);
}

} // namespace ui
