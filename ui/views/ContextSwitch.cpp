// SPDX-License-Identifier: Apache-2.0
#include "ui/views/ContextSwitch.h"

#include "ui/base/Theme.h"
#include "ui/workspace/Refinement.h"
#include "ui/workspace/Workspace.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <cmath>

namespace ui {

namespace {

/// Ids of the buttons.
enum Choice { VolumeOnly, Both, SegmentsOnly };

Choice choiceOf(gpu::Context context)
{
    switch (context) {
    case gpu::Context::Opaque:
        return VolumeOnly;
    case gpu::Context::Translucent:
    case gpu::Context::CutAway:
        return Both;
    case gpu::Context::Hidden:
        break;
    }
    return SegmentsOnly;
}

} // namespace

ContextSwitch::ContextSwitch(Workspace& workspace, QWidget* parent)
    : QFrame(parent)
    , m_workspace(workspace)
    , m_choices(new QButtonGroup(this))
    , m_ofBoth(new QWidget(this))
    , m_opacity(new QSlider(Qt::Horizontal, m_ofBoth))
    , m_cutAway(new QToolButton(m_ofBoth))
{
    setObjectName(QStringLiteral("contextSwitch"));
    setAccessibleName(tr("What the 3D view shows"));
    setCursor(Qt::ArrowCursor);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->setSpacing(0);
    const auto button = [](QToolButton* made, const QString& text, const QString& tip) {
        made->setText(text);
        made->setToolTip(tip);
        made->setCheckable(true);
        made->setFont(theme::smallFont());
        // A click leaves the keys with the view.
        made->setFocusPolicy(Qt::TabFocus);
        return made;
    };
    const auto add = [&](Choice choice, const char* name, const QString& text, const QString& tip) {
        QToolButton* made = button(new QToolButton(this), text, tip);
        made->setObjectName(QLatin1String(name));
        m_choices->addButton(made, choice);
        layout->addWidget(made);
    };
    add(VolumeOnly, "contextOpaque", tr("Volume"), tr("The volume hides what is in it (Alt+5)"));
    add(Both, "contextBoth", tr("both"),
        tr("Segments are seen through the volume (Alt+6), or it is cut away before them (Alt+7)"));
    add(SegmentsOnly, "contextHidden", tr("segments only"),
        tr("Nothing but segments and the surface that is refined (Alt+8)"));
    m_opacity->setObjectName(QStringLiteral("contextOpacity"));
    m_opacity->setAccessibleName(tr("Opacity of the volume"));
    m_opacity->setToolTip(tr("Opacity of the volume"));
    m_opacity->setRange(0, 100);
    m_opacity->setPageStep(10);
    m_opacity->setFixedWidth(48);
    m_opacity->setFocusPolicy(Qt::TabFocus);
    button(m_cutAway, tr("cut away"),
        tr("The volume is opaque, but not in front of segments and of the surface"));
    m_cutAway->setObjectName(QStringLiteral("contextCutAway"));
    auto* ofBoth = new QHBoxLayout(m_ofBoth);
    ofBoth->setContentsMargins(theme::smallPadding, 0, 0, 0);
    ofBoth->setSpacing(4);
    ofBoth->addWidget(m_opacity);
    ofBoth->addWidget(m_cutAway);
    layout->addWidget(m_ofBoth);

    connect(m_choices, &QButtonGroup::idClicked, this, [this](int id) {
        choose(id == VolumeOnly ? gpu::Context::Opaque
                : id == Both    ? m_both
                                : gpu::Context::Hidden);
    });
    connect(m_cutAway, &QToolButton::clicked, this,
        [this](bool cut) { choose(cut ? gpu::Context::CutAway : gpu::Context::Translucent); });
    connect(m_opacity, &QSlider::valueChanged, this, [this](int percent) {
        Workspace::VolumeDisplay display = m_workspace.volumeDisplay();
        display.context = gpu::Context::Translucent;
        display.contextOpacity = percent / 100.0;
        m_workspace.setVolumeDisplay(display);
    });
    connect(&workspace, &Workspace::volumeDisplayChanged, this, &ContextSwitch::showState);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_refining = m_steppedBack = false;
        m_both = gpu::Context::Translucent;
        showState();
        followSurface();
    });
    connect(&workspace.refinement(), &Refinement::changed, this, &ContextSwitch::followSurface);
    showState();
}

std::optional<gpu::Context> ContextSwitch::before() const
{
    return m_steppedBack ? std::optional(m_before) : std::nullopt;
}

void ContextSwitch::setBefore(std::optional<gpu::Context> before)
{
    m_steppedBack =
        before.has_value() && m_workspace.volumeDisplay().context == gpu::Context::Hidden;
    m_before = before.value_or(gpu::Context::Opaque);
    if (choiceOf(m_before) == Both)
        m_both = m_before;
    showState();
    // Without a surface nothing would bring it back.
    if (m_steppedBack && !m_workspace.refinement().surface()) {
        m_steppedBack = false;
        choose(m_before);
    }
}

void ContextSwitch::choose(gpu::Context context)
{
    Workspace::VolumeDisplay display = m_workspace.volumeDisplay();
    display.context = context;
    m_workspace.setVolumeDisplay(display);
}

void ContextSwitch::showState()
{
    const Workspace::VolumeDisplay& display = m_workspace.volumeDisplay();
    const Choice choice = choiceOf(display.context);
    if (choice == Both)
        m_both = display.context;
    m_steppedBack = m_steppedBack && choice == SegmentsOnly;
    m_choices->button(choice)->setChecked(true);
    m_cutAway->setChecked(m_both == gpu::Context::CutAway);
    m_ofBoth->setVisible(choice == Both);
    m_opacity->setEnabled(m_both != gpu::Context::CutAway);
    const QSignalBlocker blocker(m_opacity);
    m_opacity->setValue(int(std::lround(100.0 * display.contextOpacity)));
    setVisible(m_workspace.volume() != nullptr);
    adjustSize();
}

void ContextSwitch::followSurface()
{
    const bool refining = m_workspace.refinement().surface().has_value();
    if (refining == m_refining)
        return;
    m_refining = refining;
    const gpu::Context now = m_workspace.volumeDisplay().context;
    if (refining && now != gpu::Context::Hidden) {
        m_before = now;
        m_steppedBack = true;
        choose(gpu::Context::Hidden);
    } else if (!refining && m_steppedBack) {
        m_steppedBack = false;
        choose(m_before);
    }
}

} // namespace ui
