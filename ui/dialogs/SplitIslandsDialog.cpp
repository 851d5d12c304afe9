// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/SplitIslandsDialog.h"

#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/session/EditSession.h"
#include "ui/base/Theme.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

SplitIslandsDialog::SplitIslandsDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent, Qt::Tool) // so that the window's keys, undo above all, work in it, too
    , m_workspace(workspace)
    , m_whose(new FittingLabel(Qt::AlignLeft, this))
    , m_mm3(new QDoubleSpinBox(this))
    , m_apply(new QPushButton(tr("Split"), this))
{
    setWindowTitle(tr("Split islands into segments"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 16);
    layout->setSpacing(theme::smallPadding);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    m_whose->setObjectName(QStringLiteral("splitWhose"));
    m_whose->setFont(theme::headingFont());
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
    m_apply->setObjectName(QStringLiteral("applySplit"));
    m_apply->setDefault(true);
    auto* close = new QPushButton(tr("Close"), this);
    close->setAutoDefault(false);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(theme::smallPadding);
    buttons->addStretch(1);
    buttons->addWidget(m_apply);
    buttons->addWidget(close);
    layout->addWidget(m_whose);
    layout->addLayout(size);
    layout->addWidget(hint);
    layout->addSpacing(theme::smallPadding);
    layout->addLayout(buttons);
    connect(m_apply, &QPushButton::clicked, this, &SplitIslandsDialog::carryOut);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (isVisible() && change.what == core::DocumentChange::What::Segments)
                showState();
        });
    connect(&workspace, &Workspace::sessionChanged, this, &QDialog::reject);
}

void SplitIslandsDialog::ask(int label)
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(label) : nullptr;
    if (!segment)
        return;
    m_label = label;
    m_mm3->setValue(smallIslandMm3(m_workspace, *segment));
    showState();
    show();
    raise();
    activateWindow();
    m_mm3->setFocus();
    m_mm3->selectAll();
}

void SplitIslandsDialog::showState()
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(m_label) : nullptr;
    m_whose->setText(segment ? segment->name : QString());
    const QString why = whyUnchangeable(segment);
    m_apply->setEnabled(why.isEmpty());
    m_apply->setToolTip(why);
}

void SplitIslandsDialog::carryOut()
{
    core::SplitIslands edit{.segment = m_label};
    if (const double mm3 = m_mm3->value(); mm3 > 0.0)
        edit.mm3 = mm3;
    splitIslands(m_workspace, edit);
}

} // namespace ui
