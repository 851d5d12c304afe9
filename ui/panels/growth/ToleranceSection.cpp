// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/ToleranceSection.h"

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/ToleranceEdits.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/session/past/RecentGrowth.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/ErrorText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/panels/growth/GrowCriteriaSection.h"
#include "ui/panels/growth/PlainLimits.h"
#include "ui/panels/growth/ToleranceBar.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

constexpr int againAfterMilliseconds = 120;

/// The criteria of the section's words, as the panel calls them.
QString nameOf(const QString& field)
{
    if (field == QLatin1String("tolerance.sigmas"))
        return ToleranceSection::tr("Strokes' mean");
    if (field == QLatin1String("tolerance.difference"))
        return ToleranceSection::tr("Step at most");
    if (field == QLatin1String("tolerance.gradientDifference"))
        return ToleranceSection::tr("Gradient step");
    if (field == QLatin1String("tolerance.majority"))
        return smoothName();
    if (field == QLatin1String("tolerance.smoothing"))
        return smoothNoiseName();
    if (field == QLatin1String("tolerance.passage"))
        return necksName();
    return {};
}

} // namespace

ToleranceSection::ToleranceSection(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
{
    build();
    m_again.setSingleShot(true);
    m_again.setInterval(againAfterMilliseconds);
    connect(&m_again, &QTimer::timeout, this, &ToleranceSection::ask);
    connect(m_trace, &QPushButton::toggled, this, &ToleranceSection::turn);
    connect(m_bar, &ToleranceBar::moved, this, &ToleranceSection::preview);
    connect(m_bar, &ToleranceBar::settled, this, &ToleranceSection::settle);
    connect(&workspace, &Workspace::sessionChanged, this, &ToleranceSection::reset);
    connect(&workspace, &Workspace::activeSegmentChanged, this, [this] {
        m_bar->cancel(); // it was meant for the segment before
        m_bar->setTolerance(-1);
        follow();
    });
    const auto followRule = [this] {
        // Another interval or pace is none of its business.
        if (!isUpToDate())
            follow();
    };
    connect(&workspace, &Workspace::growSettingsChanged, this, followRule);
    connect(&workspace, &Workspace::editableChanged, this, followRule);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            using What = core::DocumentChange::What;
            if (change.what != What::Disk && change.what != What::Measurements
                && change.what != What::Chunks)
                follow();
        });
    connect(&workspace.seeds(), &PendingSeeds::changed, this, &ToleranceSection::showText);
    reset();
}

void ToleranceSection::build()
{
    m_head = new QWidget(this);
    auto* title = new QLabel(tr("Tolerance"), m_head);
    title->setProperty("role", QStringLiteral("secondary"));
    m_trace = new QPushButton(tr("Trace"), m_head);
    m_trace->setObjectName(QStringLiteral("toleranceTrace"));
    m_trace->setProperty("role", QStringLiteral("narrow"));
    m_trace->setCheckable(true);
    m_trace->setFixedHeight(theme::rowHeight);
    m_trace->setToolTip(
        tr("Find out at which distance from the seeds' mean value every voxel would join"));
    m_bar = new ToleranceBar(this);
    m_bar->setText([this](int tolerance) {
        const core::Volume* shown = m_workspace.volume();
        return shown ? toleranceText(tolerance, *shown) : QString();
    });
    m_bar->setSizeText([this](std::int64_t voxels) {
        const core::Volume* shown = m_workspace.volume();
        return shown ? millilitreText(*shown, voxels) : QString();
    });
    m_text = new QLabel(this);
    m_text->setObjectName(QStringLiteral("toleranceText"));
    m_text->setFont(theme::smallFont());
    m_text->setWordWrap(true);
    auto* head = new QHBoxLayout(m_head);
    head->setContentsMargins(0, 0, 0, 0);
    head->setSpacing(theme::smallPadding);
    head->addWidget(title);
    head->addStretch(1);
    head->addWidget(m_trace);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_head);
    layout->addWidget(m_bar);
    layout->addWidget(m_text);
}

QPushButton* ToleranceSection::takeButton()
{
    m_trace->setParent(nullptr);
    delete std::exchange(m_head, nullptr);
    showText();
    return m_trace;
}

core::Result<core::ToleranceRule> ToleranceSection::rule() const
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return core::failure(core::ErrorCode::InvalidField, QString());
    core::GrowCriteria criteria = criteriaOf(m_workspace.growSettings());
    criteria.editable = m_workspace.editableRange();
    return core::toleranceRule(m_workspace.activeSegment(), criteria, session->document());
}

/// A session takes its questions with it.
void ToleranceSection::reset()
{
    m_again.stop();
    m_on = false;
    m_asking = false;
    m_asked = nullptr;
    m_traced.reset();
    m_whyNot.clear();
    const QSignalBlocker blocker(m_trace);
    m_trace->setChecked(false);
    m_trace->setEnabled(m_workspace.session() != nullptr);
    m_bar->setCurve({}, {});
    m_bar->setTolerance(-1);
    showText();
}

void ToleranceSection::turn(bool on)
{
    m_on = on;
    m_whyNot.clear();
    if (on)
        return ask();
    m_again.stop();
    m_traced.reset();
    m_bar->setCurve({}, {});
    m_bar->setTolerance(-1);
    m_workspace.setAtTolerance({});
    if (core::EditSession* session = m_workspace.session())
        session->questions().dropTolerance();
    showText();
}

void ToleranceSection::follow()
{
    m_stale = true;
    if (m_on)
        m_again.start();
}

void ToleranceSection::ask()
{
    core::EditSession* session = m_workspace.session();
    if (!m_on || m_asking || !session)
        return;
    if (session->transactionOpen() || !session->idle()) {
        m_again.start();
        return;
    }
    const auto asked = rule();
    if (!asked)
        return refuse(asked.error());
    m_asking = true;
    m_asked = session;
    m_stale = false;
    m_whyNot.clear();
    showText();
    session->questions().traceTolerance(*asked,
        [section = QPointer<ToleranceSection>(this), session, rule = *asked](
            const core::Result<std::optional<core::ToleranceCurve>>& curve) {
            if (section && section->m_asked == session)
                section->take(rule, curve);
        });
}

void ToleranceSection::take(
    const core::ToleranceRule& rule, const core::Result<std::optional<core::ToleranceCurve>>& curve)
{
    m_asking = false;
    if (!m_on || !m_workspace.volume())
        return;
    // What overtook it, an edit most likely, is waited for.
    if (m_stale || (!curve && curve.error().arguments.value(0) == QLatin1String("transaction")))
        return m_again.start();
    if (!curve)
        return refuse(curve.error());
    const std::optional<core::ToleranceCurve>& traced = *curve;
    if (!traced)
        return ask(); // there is more to do
    m_traced = rule;
    m_centre = traced->centre;
    std::vector<std::int64_t> members = core::membersOf(*traced);
    std::vector<int> jumps = core::jumpsOf(members);
    m_bar->setCurve(std::move(members), std::move(jumps));
    if (!m_bar->moving())
        m_workspace.setAtTolerance({}); // what it was is real by now
    showText();
}

void ToleranceSection::refuse(const core::Error& error)
{
    m_traced.reset();
    m_bar->setCurve({}, {});
    m_workspace.setAtTolerance({});
    const QString field = error.arguments.value(0);
    if (field == QLatin1String("seeds") || error.code == core::ErrorCode::UnknownSegment)
        m_whyNot = tr("The active segment has no seeds: sketch some with the Seed tool.");
    else if (nameOf(field) == smoothName() || nameOf(field) == necksName())
        m_whyNot = tr("Switch “%1” off: it knows no least tolerance.").arg(nameOf(field));
    else if (nameOf(field) == smoothNoiseName())
        m_whyNot = tr("Switch “%1” off under Criteria: tolerances are those of the voxels' own "
                      "values.")
                       .arg(nameOf(field));
    else if (!nameOf(field).isEmpty())
        m_whyNot =
            tr("Switch “%1” off under Criteria: it knows no least tolerance.").arg(nameOf(field));
    else
        m_whyNot = tr("Cannot be traced: %1").arg(errorText(error));
    showText();
}

/// Whether the bar shows what would be traced now: for the segment that is active, by what is set
/// and within the editable range. Else a tolerance of the bar means another body than it shows.
bool ToleranceSection::isUpToDate() const
{
    const auto now = rule();
    return now && m_traced && *now == *m_traced;
}

void ToleranceSection::preview(int tolerance)
{
    if (!isUpToDate())
        return m_workspace.setAtTolerance({});
    m_workspace.setAtTolerance(
        gpu::ToleranceDisplay{.label = m_traced->label, .tolerance = tolerance});
    showText();
}

void ToleranceSection::settle(bool kept)
{
    const bool isMeant = isUpToDate() && m_bar->tolerance() >= 0;
    if (kept && isMeant)
        makeReal(m_bar->tolerance());
    else
        m_workspace.setAtTolerance({});
    if (kept && !isMeant)
        m_bar->setTolerance(-1); // nothing stands there
    showText();
}

void ToleranceSection::makeReal(int tolerance)
{
    core::EditSession* session = m_workspace.session();
    const core::Volume* volume = m_workspace.volume();
    if (!session || !volume)
        return;
    constexpr int lastCode = core::VoxelEncoding::codeCount - 1;
    Workspace::GrowSettings settings = m_workspace.growSettings();
    settings.lower = volume->encoding.value(std::max(m_centre - tolerance, 0));
    settings.upper = volume->encoding.value(std::min(m_centre + tolerance, lastCode));
    core::GrowCriteria criteria = criteriaOf(settings);
    criteria.editable = m_workspace.editableRange();
    // The others keep what they have: the tolerance was traced for this one alone.
    const int active = m_workspace.activeSegment();
    const std::uint8_t plane = m_workspace.growthPlane();
    criteria.plane = core::namedPlane(plane);
    if (core::growingSegments(session->history(), session->document(), plane)
            .reset(std::size_t(active))
            .any())
        criteria.segments = std::vector<int>{active};
    core::Edit edit = core::GrowSteps{.criteria = criteria};
    if (core::recentCriteria(session->history(), plane))
        edit = core::ChangeInterval{.criteria = criteria, .asBefore = false};
    if (const auto applied = session->apply(edit); !applied) {
        m_workspace.setAtTolerance({});
        m_workspace.fail(applied.error());
        return;
    }
    m_workspace.setGrowSettings(settings);
    follow();
}

void ToleranceSection::showText()
{
    const bool hasBar = !m_bar->members().empty();
    m_bar->setVisible(hasBar);
    if (std::exchange(m_hasBar, hasBar) != hasBar)
        Q_EMIT barShown(hasBar);
    QString text = m_whyNot;
    if (m_on && text.isEmpty() && m_bar->members().empty()) {
        text = tr("Working it out …");
    } else if (m_on && text.isEmpty()) {
        const std::vector<int>& jumps = m_bar->jumps();
        const int at = m_bar->tolerance();
        text = at < 0 ? tr("Drag: every view shows the segment at that tolerance.")
                      : m_bar->textFor(at);
        const auto next = std::upper_bound(jumps.begin(), jumps.end(), at);
        if (at >= 0 && next != jumps.end() && m_workspace.volume())
            text += tr(" · jumps at %1").arg(toleranceText(*next, *m_workspace.volume()));
    }
    m_text->setText(text);
    m_text->setVisible(!text.isEmpty());
    if (!m_head)
        setVisible(hasBar || !text.isEmpty());
}

} // namespace ui
