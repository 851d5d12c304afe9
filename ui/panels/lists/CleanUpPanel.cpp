// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/CleanUpPanel.h"

#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/session/EditSession.h"
#include "ui/base/MenuText.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/segment/PointedPreview.h"
#include "ui/dialogs/segment/PreviewRow.h"
#include "ui/menus/EditableButton.h"
#include "ui/menus/SegmentEntries.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <array>
#include <utility>

namespace ui {

namespace {

/// The action of the menu, and its name where the panel's header says what it is about.
struct ShortName {
    const char* id;
    const char* text;
};
constexpr const char* fillsHoles = "segments.fillHoles";
constexpr const char* keepsLargest = "segments.keepLargest";
constexpr const char* removeSmall = "segments.removeSmall";
constexpr const char* splitByThePlane = "segments.splitByPlane";
constexpr const char* inverts = "segments.invert";
constexpr int lookMilliseconds = 100;
constexpr std::array<ShortName, 10> shortNames{{
    {fillsHoles, QT_TRANSLATE_NOOP("ui::CleanUpPanel", "Fill holes")},
    {"segments.fillBetween", QT_TRANSLATE_NOOP("ui::CleanUpPanel", "Between slices …")},
    {keepsLargest, QT_TRANSLATE_NOOP("ui::CleanUpPanel", "Keep largest")},
    {"segments.splitIslands", QT_TRANSLATE_NOOP("ui::CleanUpPanel", "Split islands …")},
    {removeSmall, QT_TRANSLATE_NOOP("ui::CleanUpPanel", "Remove small")},
    {"segments.smooth", QT_TRANSLATE_NOOP("ui::CleanUpPanel", "Smooth …")},
    {"segments.margin", QT_TRANSLATE_NOOP("ui::CleanUpPanel", "Margin …")},
    {"segments.hollow", QT_TRANSLATE_NOOP("ui::CleanUpPanel", "Hollow …")},
    {splitByThePlane, QT_TRANSLATE_NOOP("ui::CleanUpPanel", "Split by plane")},
    {inverts, QT_TRANSLATE_NOOP("ui::CleanUpPanel", "Invert")},
}};

const SegmentAction* actionOf(const char* id)
{
    const std::vector<SegmentAction>& all = segmentActions();
    const auto found = std::find_if(all.begin(), all.end(),
        [id](const SegmentAction& each) { return QLatin1String(each.id) == QLatin1String(id); });
    return found == all.end() ? nullptr : &*found;
}

bool isOf(const SegmentAction& action, const char* id)
{
    return QLatin1String(action.id) == QLatin1String(id);
}

const core::Segment* activeSegmentOf(const Workspace& workspace)
{
    const core::EditSession* session = workspace.session();
    return session ? session->document().segment(workspace.activeSegment()) : nullptr;
}

} // namespace

CleanUpPanel::CleanUpPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_trial(workspace)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    grid->setSpacing(theme::smallPadding);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    setUpButtons(*grid);
    knowPreviewed();
    setUpPreview(*grid);
    grid->addWidget(
        new EditableButton(workspace, this, EditableButton::In::Column), grid->rowCount(), 0, 1, 2);
    setUpParts(*grid);
    // The menu lists segments of this study, and would go on previewing them in the next one.
    connect(&m_workspace, &Workspace::sessionClosing, m_combineMenu, &QMenu::close);
    connect(&m_workspace, &Workspace::sessionChanged, m_combineMenu, &QMenu::close);
    connect(&m_workspace, &Workspace::sessionChanged, this, [this] {
        m_isSetByHand = false;
        m_pointed->pointAtEntry(std::nullopt);
        m_combined = 0;
        refresh();
    });
    connect(&m_workspace, &Workspace::activeSegmentChanged, this, [this] {
        refresh();
        m_pointed->pointAnew();
    });
    connect(&m_workspace, &Workspace::documentChanged, this,
        [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Segments)
                refresh();
            else if (change.what == core::DocumentChange::What::History)
                m_lookSoon.start();
        });
    connect(&m_workspace.plane(), &CuttingPlane::changed, this, [this] {
        showPossible();
        m_pointed->follow();
    });
    refresh();
}

CleanUpPanel::~CleanUpPanel() = default;

void CleanUpPanel::setUpButtons(QGridLayout& grid)
{
    constexpr double mostMm3 = 1e7; // ten litres
    m_smallMm3 = new NumberField(this);
    m_smallMm3->setObjectName(QStringLiteral("cleanUp.smallMm3"));
    m_smallMm3->setAccessibleName(tr("Islands below this size are small"));
    m_smallMm3->setToolTip(tr("“Remove small” takes away islands of the segment below this size"));
    m_smallMm3->setFixedHeight(theme::rowHeight);
    m_smallMm3->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // both columns alike
    m_smallMm3->setRange(0.1, mostMm3);
    m_smallMm3->setDecimals(1);
    m_smallMm3->setSingleStep(10.0);
    m_smallMm3->setPrefix(tr("< "));
    m_smallMm3->setSuffix(tr(" mm³"));
    connect(m_smallMm3, &QDoubleSpinBox::valueChanged, this, [this] { m_isSetByHand = true; });
    int place = 0;
    const auto add = [&](QWidget* widget) {
        grid.addWidget(widget, place / 2, place % 2);
        ++place;
    };
    const auto made = [this](const QString& text, const QString& name) {
        auto* button = new QPushButton(text, this);
        button->setObjectName(name);
        button->setProperty("role", QStringLiteral("narrow"));
        button->setFixedHeight(theme::rowHeight);
        return button;
    };
    for (const ShortName& each : shortNames) {
        const SegmentAction* action = actionOf(each.id);
        if (!action)
            continue;
        QPushButton* button = made(QCoreApplication::translate("ui::CleanUpPanel", each.text),
            QStringLiteral("cleanUp.") + QLatin1String(each.id));
        connect(button, &QPushButton::clicked, this, [this, action] { run(*action); });
        m_buttons.push_back({button, action});
        add(button);
        if (isOf(*action, removeSmall))
            add(m_smallMm3);
    }
    m_combine = made(tr("Combine …"), QStringLiteral("cleanUp.combine"));
    add(m_combine);
    setUpCombine();
}

void CleanUpPanel::setUpCombine()
{
    m_combineMenu = new QMenu(m_combine);
    m_combineMenu->setObjectName(QStringLiteral("cleanUp.combinations"));
    addCombineEntries(*m_combineMenu, m_workspace, [this] { return m_workspace.activeSegment(); },
        {.choose = [this](const core::CombineSegments& edit) { combine(edit); },
            .pointedAt = [this](const core::CombineSegments* edit) { previewCombined(edit); }});
    connect(m_combine, &QPushButton::clicked, this,
        [this] { m_combineMenu->popup(m_combine->mapToGlobal(QPoint(0, m_combine->height()))); });
    // An entry that is chosen is told after its menu has closed, and takes the preview as it is.
    connect(
        m_combineMenu, &QMenu::aboutToHide, this, [this] { previewCombined(nullptr); },
        Qt::QueuedConnection);
}

void CleanUpPanel::knowPreviewed()
{
    const auto know = [this](const char* id, Previewed previewed) {
        m_previewed.emplace(QLatin1String(id), std::move(previewed));
    };
    const auto cleans = [this](core::IslandRule rule) {
        const auto carryOut = [this](const core::Edit& edit, bool isOpen) {
            cleanSegment(m_workspace, edit.get<core::CleanSegment>(), isOpen);
        };
        return Previewed{.edit = [this, rule] { return cleaning(rule); }, .carryOut = carryOut};
    };
    know(fillsHoles, cleans(core::IslandRule::FillHoles));
    know(keepsLargest, cleans(core::IslandRule::KeepLargest));
    know(removeSmall, cleans(core::IslandRule::RemoveSmall));
    const auto split = [this](const core::Edit& edit, bool isOpen) {
        splitSegment(m_workspace, edit.get<core::SplitSegment>(), isOpen);
    };
    know(splitByThePlane, {.edit = [this] { return splitting(); }, .carryOut = split});
    const auto invert = [this](const core::Edit& edit, bool isOpen) {
        takeInverse(m_workspace, edit.get<core::InvertSegment>(), isOpen);
    };
    know(inverts, {.edit = [this] { return inverting(); }, .carryOut = invert});
}

const CleanUpPanel::Previewed* CleanUpPanel::previewedOf(const SegmentAction& action) const
{
    const auto known = m_previewed.find(QLatin1String(action.id));
    return known == m_previewed.end() ? nullptr : &known->second;
}

void CleanUpPanel::setUpPreview(QGridLayout& grid)
{
    m_preview =
        new PreviewRow(m_workspace, QStringLiteral("cleanUp"), this, PreviewRow::In::Column);
    m_pointed = std::make_unique<PointedPreview>(*m_preview);
    QStringList names;
    for (const Button& each : m_buttons) {
        const Previewed* previewed = previewedOf(*each.action);
        if (!previewed)
            continue;
        names += each.button->text();
        const PointedPreview::Asked asked = [each, previewed]() -> std::optional<core::Edit> {
            if (!each.button->isEnabled())
                return std::nullopt;
            return previewed->edit();
        };
        m_pointed->watch(*each.button, asked);
        if (isOf(*each.action, removeSmall))
            m_pointed->watch(*m_smallMm3, asked);
    }
    names += tr("entries of %1").arg(m_combine->text());
    m_preview->setToolTip(tr("While the pointer rests on %1, all views show what becomes of the "
                             "segment; a click does it")
                              .arg(names.join(QStringLiteral(" · "))));
    grid.addWidget(m_preview, grid.rowCount(), 0, 1, 2);
    connect(m_smallMm3, &QDoubleSpinBox::valueChanged, m_pointed.get(), &PointedPreview::pointAnew);
    connect(&m_workspace, &Workspace::editableChanged, m_pointed.get(), &PointedPreview::follow);
    connect(m_preview, &PreviewRow::changed, this, &CleanUpPanel::followPreview);
}

/// What was being read for the parts of a split would be read of the preview.
void CleanUpPanel::followPreview()
{
    const core::EditSession* session = m_workspace.session();
    if (session && session->transactionOpen() && !m_trial.parts())
        m_trial.drop();
    else
        m_lookSoon.start();
    m_preview->showState(sizedSegment());
    // Views also draw the segment that is not there yet, in its colour.
    const bool showsSplit = session && session->isOpen<core::SplitSegment>();
    if (std::exchange(m_showsSplit, showsSplit) != showsSplit)
        Q_EMIT m_workspace.viewOptionsChanged();
}

void CleanUpPanel::previewCombined(const core::CombineSegments* edit)
{
    m_combined = edit ? edit->segment : 0;
    m_pointed->pointAtEntry(edit ? std::optional<core::Edit>(*edit) : std::nullopt);
    m_preview->showState(sizedSegment());
}

void CleanUpPanel::combine(const core::CombineSegments& edit)
{
    combineSegments(m_workspace, edit, m_preview->handOver(edit));
    m_pointed->rest();
}

const core::Segment* CleanUpPanel::sizedSegment() const
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* combined = session ? session->document().segment(m_combined) : nullptr;
    return combined ? combined : activeSegmentOf(m_workspace);
}

void CleanUpPanel::setUpParts(QGridLayout& grid)
{
    m_parts = new FittingLabel(Qt::AlignLeft, this);
    m_parts->setObjectName(QStringLiteral("cleanUp.parts"));
    m_parts->setFont(theme::smallFont());
    m_parts->setMinimumHeight(m_parts->fontMetrics().height());
    m_parts->setProperty("role", QStringLiteral("secondary"));
    m_parts->hide();
    grid.addWidget(m_parts, grid.rowCount(), 0, 1, 2);
    m_lookSoon.setSingleShot(true);
    m_lookSoon.setInterval(lookMilliseconds);
    connect(&m_lookSoon, &QTimer::timeout, this, &CleanUpPanel::lookAtParts);
    connect(&m_trial, &SplitTrial::changed, this, &CleanUpPanel::showParts);
    connect(&m_workspace, &Workspace::editableChanged, this, &CleanUpPanel::lookAtParts);
}

void CleanUpPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    m_lookSoon.start();
}

void CleanUpPanel::hideEvent(QHideEvent* event)
{
    Panel::hideEvent(event);
    m_lookSoon.stop();
    m_trial.drop();
}

QString CleanUpPanel::title() const
{
    return tr("Clean up");
}

QString CleanUpPanel::summary() const
{
    return m_summary;
}

bool CleanUpPanel::hasSomething() const
{
    const core::EditSession* session = m_workspace.session();
    return session && !session->document().segments.empty();
}

void CleanUpPanel::showPossible()
{
    const core::Segment* segment = activeSegmentOf(m_workspace);
    for (const Button& each : m_buttons) {
        QString why = segment ? whyUnchangeable(segment) : tr("no segment is active");
        if (why.isEmpty() && each.action->whyNot)
            why = each.action->whyNot(m_workspace);
        each.button->setEnabled(why.isEmpty());
        each.button->setToolTip(why.isEmpty() ? plainText(namedText(*each.action, segment)) : why);
    }
    QString why = segment ? whyUnchangeable(segment) : tr("no segment is active");
    if (why.isEmpty() && m_workspace.session()->document().segments.size() < 2)
        why = tr("there is no other segment");
    m_combine->setEnabled(why.isEmpty());
    m_combine->setToolTip(why.isEmpty() ? tr("Merge '%1' into another segment, swap both, or add, "
                                             "subtract or intersect one that may overlap")
                                              .arg(segment->name)
                                        : why);
    // The first look after a while; one that follows a plane is counted as fast as it can be.
    if (m_trial.parts())
        lookAtParts();
    else if (!m_lookSoon.isActive())
        m_lookSoon.start();
    m_smallMm3->setEnabled(segment && !segment->locked);
    if (!segment || m_isSetByHand)
        return;
    const QSignalBlocker quiet(m_smallMm3);
    m_smallMm3->setValue(smallIslandMm3(m_workspace, *segment));
}

void CleanUpPanel::lookAtParts()
{
    const auto split = std::find_if(m_buttons.begin(), m_buttons.end(),
        [](const Button& each) { return isOf(*each.action, splitByThePlane); });
    const bool isMeant = isVisible() && split != m_buttons.end() && split->button->isEnabled()
        && m_workspace.editableText().isEmpty(); // which would leave it less than is counted
    const std::optional<core::SplitSegment> edit =
        isMeant ? splitOfPlane(m_workspace, m_workspace.activeSegment()) : std::nullopt;
    if (edit)
        m_trial.look(*edit);
    else
        m_trial.drop();
    showParts();
}

void CleanUpPanel::showParts()
{
    const core::Segment* segment = activeSegmentOf(m_workspace);
    QString parts;
    if (segment && m_trial.parts())
        parts = m_trial.text(segment->name,
            core::usualParts(m_workspace.session()->document(), *segment, 1).front().name);
    m_parts->setText(parts);
    m_parts->setVisible(!parts.isEmpty());
}

std::optional<core::Edit> CleanUpPanel::cleaning(core::IslandRule rule) const
{
    core::CleanSegment edit{.segment = m_workspace.activeSegment(),
        .rule = rule,
        .editable = m_workspace.editableRange()};
    if (rule == core::IslandRule::RemoveSmall)
        edit.mm3 = m_smallMm3->value();
    return edit;
}

std::optional<core::Edit> CleanUpPanel::splitting() const
{
    std::optional<core::SplitSegment> edit = splitOfPlane(m_workspace, m_workspace.activeSegment());
    if (!edit)
        return std::nullopt;
    edit->editable = m_workspace.editableRange();
    return *edit;
}

std::optional<core::Edit> CleanUpPanel::inverting() const
{
    return core::InvertSegment{
        .segment = m_workspace.activeSegment(), .editable = m_workspace.editableRange()};
}

void CleanUpPanel::run(const SegmentAction& action)
{
    const Previewed* previewed = previewedOf(action);
    const std::optional<core::Edit> edit = previewed ? previewed->edit() : std::nullopt;
    if (!edit)
        return action.run(m_workspace, m_workspace.activeSegment());
    previewed->carryOut(*edit, m_preview->handOver(*edit));
    m_pointed->rest();
}

void CleanUpPanel::refresh()
{
    showPossible();
    const core::Segment* segment = activeSegmentOf(m_workspace);
    m_preview->showState(sizedSegment());
    m_summary = segment ? segment->name : QString();
    Q_EMIT summaryChanged(m_summary);
    if (const bool now = hasSomething(); now != m_hadSomething) {
        m_hadSomething = now;
        Q_EMIT hasSomethingChanged();
    }
}

} // namespace ui
