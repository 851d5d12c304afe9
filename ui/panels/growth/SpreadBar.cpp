// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/SpreadBar.h"

#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "ui/base/Theme.h"
#include "ui/widgets/FoldButton.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int barMilliseconds = 40;
constexpr int againAfterMilliseconds = 150;

QPushButton* button(QWidget* parent, const char* name, const QString& text, const QString& tip)
{
    auto* made = new QPushButton(text, parent);
    made->setObjectName(QLatin1String(name));
    made->setProperty("role", QStringLiteral("narrow"));
    made->setFixedHeight(theme::rowHeight);
    made->setToolTip(tip);
    return made;
}

} // namespace

SpreadBar::SpreadBar(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
{
    build();
    m_watch.setInterval(barMilliseconds);
    connect(&m_watch, &QTimer::timeout, this, &SpreadBar::follow);
    connect(m_preview, &QPushButton::clicked, this, &SpreadBar::preview);
    connect(m_apply, &QPushButton::clicked, this, &SpreadBar::apply);
    connect(m_cancel, &QPushButton::clicked, this, &SpreadBar::cancel);
    m_again.setSingleShot(true);
    m_again.setInterval(againAfterMilliseconds);
    connect(&m_again, &QTimer::timeout, this, &SpreadBar::beginAgain);
    connect(m_extent, &QComboBox::activated, this, &SpreadBar::beginAgain);
    connect(&workspace, &Workspace::editableChanged, this, [this] {
        if (m_wanted && m_workspace.editableRange() != m_begunWithin)
            m_again.start();
    });
    connect(&workspace, &Workspace::sessionChanged, this, &SpreadBar::stop);
    connect(&workspace, &Workspace::documentChanged, this, &SpreadBar::showState);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &SpreadBar::showState);
    connect(&workspace.seeds(), &PendingSeeds::changed, this, &SpreadBar::showState);
    connect(&workspace, &Workspace::failed, this, [this] {
        // A preview that was refused would be refused again.
        const core::EditSession* session = m_workspace.session();
        if (m_wanted && session && !session->isOpen<core::GrowFromSeeds>()
            && !session->transactionOpen())
            stop();
    });
    showState();
}

void SpreadBar::build()
{
    auto* body = new QWidget(this);
    m_fold = new FoldButton(*body, this);
    m_fold->setObjectName(QStringLiteral("spreadFold"));
    m_fold->setToolTip(tr("Two or more segments share out what lies between their seeds"));
    auto* extentLabel = new QLabel(tr("Share out"), body);
    extentLabel->setProperty("role", QStringLiteral("secondary"));
    m_extent = new QComboBox(body);
    m_extent->setObjectName(QStringLiteral("spreadExtent"));
    m_extent->setFixedHeight(theme::controlHeight);
    m_extent->addItem(tr("a box around them"), false);
    m_extent->addItem(tr("the whole volume"), true);
    m_extent->setToolTip(tr("What the segments share out among themselves"));
    m_preview = button(body, "spreadPreview", tr("Preview"),
        tr("Give every voxel to the segment from whose seeds values change least on the way"));
    m_apply = button(body, "spreadApply", tr("Apply"), tr("Keep what is shown, as one step"));
    m_cancel = button(body, "spreadCancel", tr("Cancel"), tr("Take the preview back"));
    m_text = new QLabel(body);
    m_text->setObjectName(QStringLiteral("spreadText"));
    m_text->setFont(theme::smallFont());
    m_text->setProperty("role", QStringLiteral("secondary"));
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    // So that what stands below does not jump with what it says.
    m_text->setMinimumHeight(2 * m_text->fontMetrics().lineSpacing());

    auto* head = new QHBoxLayout;
    head->setSpacing(theme::smallPadding);
    head->addWidget(extentLabel);
    head->addWidget(m_extent, 1);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(theme::smallPadding);
    for (QPushButton* each : {m_preview, m_apply, m_cancel})
        buttons->addWidget(each, 1);
    auto* rows = new QVBoxLayout(body);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(theme::smallPadding);
    rows->addLayout(head);
    rows->addLayout(buttons);
    rows->addWidget(m_text);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_fold, 0, Qt::AlignLeft);
    layout->addWidget(body);
}

core::GrowFromSeeds SpreadBar::edit() const
{
    core::GrowFromSeeds made;
    const core::Volume* volume = m_workspace.volume();
    if (volume && m_extent->currentData().toBool()) {
        const core::VolumeGeometry& geometry = volume->geometry;
        made.box = core::GrowBox{
            geometry.toWorld(glm::dvec3(0.0)), geometry.toWorld(glm::dvec3(geometry.size) - 1.0)};
    }
    made.connectivity = m_workspace.growSettings().connectivity;
    made.overwriteUnlocked = m_workspace.growSettings().overwriteUnlocked;
    made.plane = core::namedPlane(plane());
    made.editable = m_workspace.editableRange();
    return made;
}

/// It stays with its segments while it is shown, whichever becomes the active one.
std::uint8_t SpreadBar::plane() const
{
    return m_wanted ? m_plane : m_workspace.growthPlane();
}

void SpreadBar::preview()
{
    m_plane = plane();
    m_wanted = true;
    begin();
}

void SpreadBar::begin()
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return stop();
    m_again.stop();
    m_begunAt = session->history().position();
    m_begunWithin = m_workspace.editableRange();
    if (const auto begun = session->begin(edit()); !begun) {
        stop();
        m_workspace.fail(begun.error());
        return;
    }
    m_sinceBegun.start();
    m_watch.start();
    showState();
}

/// Something else that stands open meanwhile, a growth for instance, is left alone: the preview
/// comes back after it, with what is chosen by then.
void SpreadBar::beginAgain()
{
    const core::EditSession* session = m_workspace.session();
    if (!m_wanted || !session)
        return;
    if (session->isOpen<core::GrowFromSeeds>())
        return begin();
    m_begunAt.reset();
}

void SpreadBar::follow()
{
    core::EditSession* session = m_workspace.session();
    if (!m_wanted || !session)
        return stop();
    if (session->isOpen<core::GrowFromSeeds>())
        return showState();
    if (session->transactionOpen()) {
        m_begunAt.reset();
        return;
    }
    // What took the preview back may still be under way; what was refused stays so.
    if (!session->idle())
        return;
    if (competitors() < 2 || m_begunAt == session->history().position())
        return stop();
    begin();
}

void SpreadBar::apply()
{
    core::EditSession* session = m_workspace.session();
    const bool open = session && session->isOpen<core::GrowFromSeeds>();
    // What is kept is what the settings say, not what was shown of those before.
    if (open && m_again.isActive()) {
        begin();
        if (!m_wanted)
            return; // it was refused
    }
    stop();
    if (open)
        session->end(core::Ending::Commit);
}

void SpreadBar::cancel()
{
    core::EditSession* session = m_workspace.session();
    stop();
    if (session)
        session->forgetPreview();
}

void SpreadBar::stop()
{
    m_watch.stop();
    m_again.stop();
    m_wanted = false;
    m_begunAt.reset();
    showState();
}

int SpreadBar::competitors() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return 0;
    const std::vector<gpu::SceneSeed>& seeds = m_workspace.seeds().seeds();
    const std::vector<core::Segment>& segments = session->document().segments;
    const std::uint8_t plane = this->plane();
    return int(std::count_if(
        segments.begin(), segments.end(), [&seeds, plane](const core::Segment& segment) {
            return segment.plane == plane && !segment.locked
                && (segment.voxels > 0
                    || std::any_of(seeds.begin(), seeds.end(),
                        [&segment](const auto& seed) { return seed.label == segment.label; }));
        }));
}

void SpreadBar::showState()
{
    core::EditSession* session = m_workspace.session();
    const int count = competitors();
    const bool shown = session && session->isOpen<core::GrowFromSeeds>();
    const bool working = shown && session->growthProgress().running;
    m_preview->setEnabled(!m_wanted && count >= 2);
    m_apply->setEnabled(m_wanted && shown);
    m_cancel->setEnabled(m_wanted);
    m_extent->setEnabled(session != nullptr);
    m_fold->setText(m_wanted ? tr("Grow from seeds · preview")
            : count >= 2     ? tr("Grow from seeds · %1 segments").arg(count)
                             : tr("Grow from seeds"));
    if (working && m_sinceBegun.elapsed() >= 2000)
        m_text->setText(tr("Working it out, for %1 s so far …").arg(m_sinceBegun.elapsed() / 1000));
    else if (working)
        m_text->setText(tr("Working it out …"));
    else if (m_wanted)
        m_text->setText(tr("Shown in all views. Sketch, paint or erase to correct it; Apply keeps "
                           "it."));
    else if (count >= 2)
        m_text->setText(tr("They compete for what lies between; the preview shows who gets what."));
    else
        m_text->setText(
            tr("Sketch or paint in two segments or more: they share out what lies between."));
}

} // namespace ui
