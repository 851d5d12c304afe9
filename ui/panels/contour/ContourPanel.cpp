// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/contour/ContourPanel.h"

#include "core/edits/kinds/filling/EvolveContour.h"
#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/panels/growth/GrowthButtons.h"
#include "ui/tools/contour/ContourTool.h"
#include "ui/widgets/StepSlider.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/widgets/fields/ValueField.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

/// A number of the volume's values.
QDoubleSpinBox* contourField(QWidget* parent, const char* name, const QString& tip)
{
    QDoubleSpinBox* box = valueField(parent, name);
    box->setMinimumWidth(60);
    box->setToolTip(tip);
    return box;
}

} // namespace

ContourPanel::ContourPanel(Workspace& workspace, ContourTool& tool, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_tool(tool)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, theme::smallPadding, 0, theme::smallPadding);
    layout->setSpacing(theme::smallPadding);
    auto* form = new QFormLayout;
    form->setContentsMargins(theme::padding, 0, theme::padding, 0);
    form->setSpacing(theme::smallPadding);
    layout->addLayout(form);
    buildRule(*form);
    buildRun();
    showSettings();
    showRun();
    connect(&tool, &ContourTool::settingsChanged, this, &ContourPanel::showSettings);
    connect(&tool.run(), &ContourRun::changed, this, &ContourPanel::showRun);
    connect(&workspace, &Workspace::growSettingsChanged, this, &ContourPanel::showSettings);
    for (const auto signal : {&Workspace::activeToolChanged, &Workspace::sessionChanged}) {
        connect(&workspace, signal, this, [this] {
            showSettings();
            showRun();
            if (const bool now = hasSomething(); now != m_hadSomething) {
                m_hadSomething = now;
                Q_EMIT hasSomethingChanged();
            }
        });
    }
    m_hadSomething = hasSomething();
}

QString ContourPanel::title() const
{
    return tr("Contour");
}

QString ContourPanel::summary() const
{
    const ContourRun& run = m_tool.run();
    if (!run.isOpen())
        return {};
    return run.isWorking()    ? tr("working")
        : run.rests()         ? tr("at rest")
        : run.isOutOfMemory() ? tr("no more memory")
                              : tr("at the limit");
}

bool ContourPanel::hasSomething() const
{
    return m_workspace.session() && m_workspace.activeTool() == &m_tool;
}

/// 0 … 100, with its number behind it.
QSlider* ContourPanel::share(
    QFormLayout& form, const char* name, const QString& label, const QString& tip)
{
    auto* slider = new QSlider(Qt::Horizontal, this);
    slider->setObjectName(QLatin1String(name));
    slider->setRange(0, 100);
    slider->setToolTip(tip);
    auto* number = new QLabel(this);
    number->setFixedWidth(28);
    number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const auto show = [number](int value) { number->setText(QString::number(value)); };
    show(slider->value());
    connect(slider, &QSlider::valueChanged, number, show);
    auto* row = new QHBoxLayout;
    row->setSpacing(theme::smallPadding);
    row->addWidget(slider, 1);
    row->addWidget(number);
    form.addRow(label, row);
    connect(slider, &QSlider::valueChanged, this, &ContourPanel::takeSettings);
    return slider;
}

void ContourPanel::buildRule(QFormLayout& form)
{
    m_lower = contourField(this, "contourLower",
        tr("The contour moves outwards from this value on, and inwards below "
           "it; growth has the same interval"));
    m_upper = contourField(this, "contourUpper",
        tr("The contour moves outwards up to this value, and inwards above "
           "it; growth has the same interval"));
    auto* interval = new QHBoxLayout;
    interval->setSpacing(theme::smallPadding);
    interval->addWidget(m_lower, 4);
    interval->addWidget(m_upper, 5); // with the unit
    form.addRow(tr("Values"), interval);
    m_ofBubble = new QCheckBox(tr("as around the bubble"), this);
    m_ofBubble->setObjectName(QStringLiteral("contourOfBubble"));
    m_ofBubble->setToolTip(
        tr("Bubbles set the interval to the values where they are clicked, or that the seeds have, "
           "as a sketch does for growth; one that you set yourself stays"));
    form.addRow(QString(), m_ofBubble);
    connect(m_ofBubble, &QCheckBox::clicked, this, &ContourPanel::takeSettings);
    m_softness = share(form, "contourSoftness", tr("Soft"),
        tr("How far from the ends of the interval a value counts in full, in per cent of half its "
           "width"));
    m_smoothness = share(form, "contourSmoothness", tr("Smooth"),
        tr("How much a short contour counts: more of it removes specks and stops leaks through "
           "narrow places"));
    m_edge = share(
        form, "contourEdge", tr("Edges"), tr("How much edges hold the contour; 0: not at all"));
    m_gradient = contourField(
        this, "contourGradient", tr("The gradient of an edge that counts half, per millimetre"));
    m_gradient->setRange(0.001, ContourSettings::maximumGradient);
    form.addRow(tr("Edge from"), m_gradient);
    m_generations = new WholeNumberField(this);
    m_generations->setObjectName(QStringLiteral("contourGenerations"));
    m_generations->setFixedHeight(theme::controlHeight);
    m_generations->setKeyboardTracking(false);
    m_generations->setRange(1, core::mostContourGenerations);
    m_generations->setToolTip(
        tr("How many generations it evolves, each by a voxel; it stops earlier where nothing "
           "changes any more"));
    form.addRow(tr("At most"), m_generations);
    connect(m_lower, &QDoubleSpinBox::valueChanged, this, [this](double lower) {
        takeInterval(lower, std::max(lower, m_workspace.growSettings().upper));
    });
    connect(m_upper, &QDoubleSpinBox::valueChanged, this, [this](double upper) {
        takeInterval(std::min(upper, m_workspace.growSettings().lower), upper);
    });
    connect(m_gradient, &QDoubleSpinBox::valueChanged, this, [this](double gradient) {
        ContourSettings now = m_tool.settings();
        now.edgeGradient = gradient;
        m_tool.setSettings(now);
    });
    connect(m_generations, &QSpinBox::valueChanged, this, &ContourPanel::takeSettings);
}

void ContourPanel::buildRun()
{
    m_bar = new StepSlider(this);
    m_bar->setObjectName(QStringLiteral("contourBar"));
    m_bar->setToolTip(tr("The generations of the contour, forwards and backwards"));
    m_play =
        transportButton(this, QStringLiteral("contourPlay"), QStringLiteral("play"), tr("Play"));
    m_accept = narrowButton(this, QStringLiteral("contourAccept"), tr("Accept"));
    m_accept->setToolTip(tr("Makes a step of the generation that is shown (Enter over a view)"));
    m_abort = narrowButton(this, QStringLiteral("contourAbort"), tr("Abort"));
    m_abort->setToolTip(tr("Leaves nothing (Esc over a view)"));
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(theme::padding, 0, theme::padding, 0);
    buttons->setSpacing(theme::smallPadding);
    buttons->addWidget(m_play, 1);
    buttons->addWidget(m_accept, 1);
    buttons->addWidget(m_abort, 1);
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->addWidget(m_bar);
    column->addLayout(buttons);
    connect(m_bar, &StepSlider::valueChanged, this,
        [this](int generation) { m_tool.run().goTo(generation); });
    connect(m_play, &QPushButton::clicked, this, &ContourPanel::playOrPause);
    connect(m_accept, &QPushButton::clicked, &m_tool, &ContourTool::accept);
    connect(m_abort, &QPushButton::clicked, this, [this] { m_tool.drop(); });
}

void ContourPanel::showSettings()
{
    const core::Volume* volume = m_workspace.volume();
    const ContourSettings& its = m_tool.settings();
    const GrowSettings& growth = m_workspace.growSettings();
    const QString unit = volume ? QLatin1Char(' ') + volume->unit : QString();
    // A volume of fractions needs them here too.
    const int decimals = volume && volume->maximum - volume->minimum < 50.0 ? 3 : 1;
    const auto set = [](auto* widget, auto value) {
        const QSignalBlocker blocker(widget);
        widget->setValue(value);
    };
    for (QDoubleSpinBox* box : {m_lower, m_upper, m_gradient}) {
        const QSignalBlocker blocker(box);
        box->setDecimals(decimals);
    }
    m_ofBubble->setChecked(its.valuesOfBubble);
    m_upper->setSuffix(unit);
    m_gradient->setSuffix(unit + tr("/mm"));
    set(m_lower, growth.lower);
    set(m_upper, growth.upper);
    // The numbers behind them follow by the same signal.
    m_showing = true;
    m_softness->setValue(its.softness);
    m_smoothness->setValue(its.smoothness);
    m_edge->setValue(its.edge);
    m_showing = false;
    set(m_gradient, m_tool.edgeGradient());
    m_gradient->setEnabled(its.edge > 0);
    set(m_generations, its.generations);
}

void ContourPanel::takeInterval(double lower, double upper)
{
    GrowSettings growth = m_workspace.growSettings();
    growth.lower = lower;
    growth.upper = upper;
    m_workspace.setGrowSettings(growth);
    // The next bubble is to keep it.
    ContourSettings now = m_tool.settings();
    now.valuesOfBubble = false;
    m_tool.setSettings(now);
}

void ContourPanel::takeSettings()
{
    if (m_showing)
        return;
    ContourSettings now = m_tool.settings();
    now.valuesOfBubble = m_ofBubble->isChecked();
    now.softness = m_softness->value();
    now.smoothness = m_smoothness->value();
    now.edge = m_edge->value();
    now.generations = m_generations->value();
    m_tool.setSettings(now);
}

void ContourPanel::playOrPause()
{
    ContourRun& run = m_tool.run();
    if (run.isOpen())
        run.setPlaying(!run.isPlaying());
    else
        m_tool.start(m_workspace.crosshairLps());
}

void ContourPanel::showRun()
{
    const ContourRun& run = m_tool.run();
    const core::ContourTrack* track = run.track();
    const QSignalBlocker blocker(m_bar);
    m_bar->setRange(0, track ? track->known() : 0);
    m_bar->setValue(track ? track->shown() : 0);
    m_bar->setEnabled(track != nullptr);
    m_bar->setCaption(track ? m_tool.shownText()
            : run.isOpen()  ? tr("reading the voxels around it")
                            : tr("click a slice, or play from the crosshair"));
    m_bar->update(); // nobody heard of another range
    m_play->setText(run.isPlaying() ? tr("Pause") : tr("Play"));
    m_play->setIcon(stateIcon(run.isPlaying() ? QStringLiteral("pause") : QStringLiteral("play")));
    m_accept->setEnabled(run.shownEdit().has_value());
    m_abort->setEnabled(run.isOpen());
    Q_EMIT summaryChanged(summary());
}

} // namespace ui
