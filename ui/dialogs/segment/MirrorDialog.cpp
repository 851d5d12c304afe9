// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/MirrorDialog.h"

#include "ui/base/Theme.h"
#include "ui/dialogs/segment/PreviewRow.h"
#include "ui/dialogs/segment/SegmentWorkRow.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace ui {

MirrorDialog::MirrorDialog(Workspace& workspace, QWidget* parent)
    : SegmentDialog(workspace, tr("Mirror a segment"), QStringLiteral("mirror"), parent)
    , m_sides(new QComboBox(this))
    , m_place(new QComboBox(this))
    , m_keep(new QCheckBox(tr("keep the segment beside its image"), this))
    , m_preview(new PreviewRow(workspace, QStringLiteral("mirror"), this))
    , m_work(new SegmentWorkRow(workspace, QStringLiteral("Mirror"), tr("Apply"), this))
{
    m_sides->setObjectName(QStringLiteral("mirrorSides"));
    m_sides->setAccessibleName(tr("Which sides are exchanged"));
    m_sides->addItem(tr("Left and right")); // as MirroredSides
    m_sides->addItem(tr("Front and back"));
    m_sides->addItem(tr("Head and feet"));
    m_place->setObjectName(QStringLiteral("mirrorPlace"));
    m_place->setAccessibleName(tr("About what it is mirrored"));
    m_place->addItem(tr("about the middle of the images"));
    m_place->addItem(tr("about the crosshair"));
    auto* row = new QHBoxLayout;
    row->setSpacing(theme::smallPadding);
    row->addWidget(m_sides, 1);
    row->addWidget(m_place, 1);
    auto* hint = new QLabel(tr("Takes only voxels that no segment has."), this);
    hint->setFont(theme::smallFont());
    hint->setProperty("role", QStringLiteral("secondary"));
    m_keep->setObjectName(QStringLiteral("mirrorKeep"));
    constexpr int leastWidth = 380; // that nothing moves when the texts change
    column().addLayout(row);
    column().addWidget(hint);
    column().addWidget(m_keep);
    addEditable();
    column().addSpacing(theme::smallPadding);
    column().addWidget(m_preview);
    column().addWidget(m_work);
    m_preview->setMinimumWidth(leastWidth);
    connect(m_sides, &QComboBox::currentIndexChanged, this, &MirrorDialog::follow);
    connect(m_place, &QComboBox::currentIndexChanged, this, &MirrorDialog::follow);
    connect(m_keep, &QCheckBox::toggled, this, &MirrorDialog::follow);
    connect(m_work, &SegmentWorkRow::asked, this, &MirrorDialog::carryOut);
    connect(m_work, &SegmentWorkRow::looked, this, &MirrorDialog::showState);
    connect(m_work, &SegmentWorkRow::closed, this, &QDialog::reject);
    connect(&workspace, &Workspace::documentChanged, this, &MirrorDialog::showState);
    connect(&workspace, &Workspace::editableChanged, this, &MirrorDialog::follow);
    connect(&workspace, &Workspace::crosshairChanged, this, [this] {
        if (m_place->currentIndex() > 0)
            follow();
    });
    connect(m_preview, &PreviewRow::switched, this, &MirrorDialog::follow);
    connect(m_preview, &PreviewRow::changed, this, [this] {
        m_work->follow();
        showState();
    });
}

void MirrorDialog::ask(int label)
{
    setLabel(label);
    showState();
    bringUp();
    m_work->focusApply();
    follow();
}

void MirrorDialog::showState()
{
    SegmentDialog::showState();
    m_work->showWhyNot(whyUnchangeable(segment()));
    m_preview->showState(segment());
}

core::MirrorSegment MirrorDialog::chosen() const
{
    core::MirrorSegment edit{.segment = label(),
        .sides = core::MirroredSides(m_sides->currentIndex()),
        .keep = m_keep->isChecked(),
        .editable = workspace().editableRange()};
    if (m_place->currentIndex() > 0)
        edit.placeLps = workspace().crosshairLps();
    return edit;
}

void MirrorDialog::follow()
{
    if (isVisible())
        m_preview->preview(whyUnchangeable(segment()).isEmpty()
                ? std::optional<core::Edit>(chosen())
                : std::nullopt);
}

void MirrorDialog::carryOut()
{
    const core::MirrorSegment edit = chosen();
    mirrorSegment(workspace(), edit, m_preview->handOver(edit));
    m_work->follow();
    showState();
}

} // namespace ui
