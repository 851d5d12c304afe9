// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/SplitIslandsDialog.h"

#include "core/islands/SegmentIslands.h"
#include "core/session/EditSession.h"
#include "ui/base/CountText.h"
#include "ui/base/Theme.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

SplitIslandsDialog::SplitIslandsDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent, Qt::Tool) // so that the window's keys, undo above all, work in it, too
    , m_workspace(workspace)
    , m_whose(new FittingLabel(Qt::AlignLeft, this))
    , m_mm3(new QDoubleSpinBox(this))
    , m_result(new QLabel(this))
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
    layout->addWidget(m_whose);
    layout->addLayout(size);
    layout->addWidget(hint);
    layout->addWidget(m_result);
    layout->addSpacing(theme::smallPadding);
    layout->addLayout(buttons);
    m_lookSoon.setSingleShot(true);
    connect(&m_lookSoon, &QTimer::timeout, this, &SplitIslandsDialog::look);
    connect(&m_fetch, &LabelFetch::finished, this, &SplitIslandsDialog::count);
    connect(&m_fetch, &LabelFetch::failed, this, [this] {
        forget();
        showState();
    });
    connect(m_mm3, &QDoubleSpinBox::valueChanged, this, &SplitIslandsDialog::showState);
    connect(m_apply, &QPushButton::clicked, this, &SplitIslandsDialog::carryOut);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (!isVisible())
                return;
            // The history also tells when a step is on the disk.
            if (change.what == core::DocumentChange::What::History
                && m_position != m_workspace.session()->history().position())
                m_lookSoon.start();
            showState();
        });
    connect(&workspace, &Workspace::sessionClosing, this, &SplitIslandsDialog::forget);
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
    show();
    raise();
    activateWindow();
    m_mm3->setFocus();
    m_mm3->selectAll();
    look();
}

void SplitIslandsDialog::hideEvent(QHideEvent* event)
{
    if (!event->spontaneous())
        forget();
    QDialog::hideEvent(event);
}

void SplitIslandsDialog::forget()
{
    m_lookSoon.stop();
    m_fetch.cancel();
    m_counting.cancel();
    m_sizes.reset();
    m_looking = false;
    m_position.reset();
}

void SplitIslandsDialog::look()
{
    forget();
    core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(m_label) : nullptr;
    // What is open ends with a step, after which it is looked again.
    m_looking = segment && !session->transactionOpen();
    if (m_looking) {
        m_position = session->history().position();
        m_fetch.start(*session, {segment->plane});
    }
    showState();
}

void SplitIslandsDialog::count(const LabelFetch::Planes& planes)
{
    m_counting.replace(
        this,
        [planes, size = m_workspace.volume()->geometry.size, label = std::uint8_t(m_label)](
            const core::Progress& progress) {
            return core::islandSizes(planes->front().labels, size, label, progress);
        },
        [this](const core::Result<std::vector<std::int64_t>>& sizes) {
            m_looking = false;
            if (sizes)
                m_sizes = *sizes;
            showState();
        });
}

core::SplitIslands SplitIslandsDialog::chosen() const
{
    core::SplitIslands edit{.segment = m_label};
    if (const double mm3 = m_mm3->value(); mm3 > 0.0)
        edit.mm3 = mm3;
    return edit;
}

void SplitIslandsDialog::showState()
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment = session ? session->document().segment(m_label) : nullptr;
    m_whose->setText(segment ? segment->name : QString());
    QString why = whyUnchangeable(segment);
    QString result = m_looking ? tr("Looking …") : QString();
    if (segment && m_sizes) {
        const std::int64_t least = core::leastVoxels(chosen(), m_workspace.volume()->geometry);
        const auto large = std::count_if(m_sizes->begin(), m_sizes->end(),
            [least](std::int64_t voxels) { return voxels >= least; });
        // The largest stays, however small it is.
        const auto others = std::max<std::int64_t>(0, large - 1);
        const auto room = std::int64_t(core::roomForSegments(session->document()));
        if (others == 0)
            result = tr("No island beside the largest is so large");
        else if (others > room)
            result = tr("%1 islands are so large, but there can be only %2 segments more")
                         .arg(countText(others), countText(room));
        else if (others == 1)
            result = tr("1 of %1 islands becomes a segment").arg(countText(m_sizes->size()));
        else
            result = tr("%1 of %2 islands become segments")
                         .arg(countText(others), countText(m_sizes->size()));
        if (why.isEmpty() && (others == 0 || others > room))
            why = result;
    }
    m_result->setText(result);
    m_apply->setEnabled(why.isEmpty());
    m_apply->setToolTip(why);
}

void SplitIslandsDialog::carryOut()
{
    splitIslands(m_workspace, chosen());
}

} // namespace ui
