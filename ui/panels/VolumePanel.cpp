// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/VolumePanel.h"

#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/frame/TransferFunctionEditor.h"
#include "ui/settings/TransferPresets.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/InitialDisplay.h"
#include "ui/workspace/Workspace.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr int sliderSteps = 1000;

QWidget* labelled(QWidget* parent, const QString& name, QWidget* field)
{
    auto* row = new QWidget(parent);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    auto* label = new QLabel(name, row);
    label->setProperty("role", QStringLiteral("secondary"));
    label->setMinimumWidth(64);
    layout->addWidget(label);
    layout->addWidget(field, 1);
    return row;
}

} // namespace

VolumePanel::VolumePanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
{
    build();
    connect(m_modes, &QButtonGroup::idClicked, this, &VolumePanel::takeMode);
    connect(m_threshold, &QDoubleSpinBox::valueChanged, this, &VolumePanel::takeThreshold);
    connect(m_slider, &QSlider::valueChanged, this, [this](int step) {
        const double range = m_threshold->maximum() - m_threshold->minimum();
        const double value = m_threshold->minimum() + range * step / sliderSteps;
        m_threshold->setValue(value); // rounds to the digits that are shown
    });
    connect(m_function, &TransferFunctionEditor::functionEdited, this,
        [this](const gpu::TransferFunction& function) {
            Workspace::VolumeDisplay display = m_workspace.volumeDisplay();
            display.transferFunction = function;
            m_workspace.setVolumeDisplay(display);
        });
    connect(m_preset, &QComboBox::activated, this, &VolumePanel::takePreset);
    connect(m_window, &QComboBox::activated, this, &VolumePanel::takeWindow);
    connect(&workspace, &Workspace::sessionChanged, this, &VolumePanel::showVolume);
    connect(&workspace, &Workspace::volumeDisplayChanged, this, &VolumePanel::showDisplay);
    connect(&workspace, &Workspace::windowLevelChanged, this, &VolumePanel::showDisplay);
    showVolume();
}

void VolumePanel::build()
{
    m_modes = new QButtonGroup(this);
    auto* modes = new QHBoxLayout;
    modes->setSpacing(4);
    const std::pair<gpu::RenderMode, QString> names[] = {
        {gpu::RenderMode::Surface, tr("Isosurface")}, {gpu::RenderMode::Dvr, tr("DVR")},
        {gpu::RenderMode::Mip, tr("MIP")}, {gpu::RenderMode::Xray, tr("X-ray")}};
    for (const auto& [mode, name] : names) {
        auto* button = new QPushButton(name, this);
        button->setObjectName(QStringLiteral("renderMode%1").arg(int(mode)));
        button->setCheckable(true);
        m_modes->addButton(button, int(mode));
        button->setProperty("role", QStringLiteral("narrow"));
        modes->addWidget(button, 1);
    }
    m_modes->button(int(gpu::RenderMode::Dvr))->setToolTip(tr("Direct volume rendering"));
    m_modes->button(int(gpu::RenderMode::Mip))->setToolTip(tr("Maximum intensity projection"));
    m_modes->button(int(gpu::RenderMode::Xray))
        ->setToolTip(tr("The mean of what is visible along each line of sight"));

    m_slider = new QSlider(Qt::Horizontal, this);
    m_slider->setRange(0, sliderSteps);
    m_slider->setAccessibleName(tr("Isosurface threshold"));
    m_threshold = new NumberField(this);
    m_threshold->setObjectName(QStringLiteral("surfaceThreshold"));
    m_threshold->setKeyboardTracking(false);
    m_threshold->setFixedHeight(theme::controlHeight);
    m_threshold->setMinimumWidth(92);
    auto* threshold = new QWidget(this);
    auto* thresholdLayout = new QHBoxLayout(threshold);
    thresholdLayout->setContentsMargins(0, 0, 0, 0);
    thresholdLayout->addWidget(m_slider, 1);
    thresholdLayout->addWidget(m_threshold);
    m_surfaceRow = labelled(this, tr("Threshold"), threshold);
    m_function = new TransferFunctionEditor(this);
    m_function->setObjectName(QStringLiteral("transferFunction"));
    m_preset = new QComboBox(this);
    m_preset->setObjectName(QStringLiteral("transferPreset"));
    m_preset->setFixedHeight(theme::controlHeight);
    m_window = new QComboBox(this);
    m_window->setObjectName(QStringLiteral("windowPreset"));
    m_window->setFixedHeight(theme::controlHeight);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(theme::padding, theme::smallPadding, theme::padding, theme::padding);
    layout->setSpacing(theme::smallPadding);
    layout->addLayout(modes);
    layout->addWidget(m_surfaceRow);
    layout->addWidget(m_function);
    layout->addWidget(labelled(this, tr("Preset"), m_preset));
    layout->addWidget(labelled(this, tr("Slices"), m_window));
}

QString VolumePanel::title() const
{
    return tr("Volume");
}

QString VolumePanel::summary() const
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return {};
    const glm::ivec3 size = volume->geometry.size;
    return tr("%1 × %2 × %3").arg(size.x).arg(size.y).arg(size.z);
}

void VolumePanel::showVolume()
{
    const core::Volume* volume = m_workspace.volume();
    setEnabled(volume != nullptr);
    m_preset->clear();
    m_window->clear();
    if (volume) {
        m_function->setHistogram(volume->histogram);
        m_function->setUnit(volume->unit);
        const QSignalBlocker blocker(m_threshold);
        const double span = volume->maximum - volume->minimum;
        m_threshold->setDecimals(span >= 500.0 ? 0 : std::max(2, decimalsForSpan(span)));
        m_threshold->setRange(volume->minimum, volume->maximum);
        m_threshold->setSuffix(
            volume->unit.isEmpty() ? QString() : QStringLiteral(" ") + volume->unit);
        for (const TransferPreset& preset : transferPresets(*volume))
            m_preset->addItem(preset.name);
        for (const WindowPreset& preset : windowPresets(*volume))
            m_window->addItem(preset.name);
    }
    m_preset->addItem(tr("own"));
    m_window->addItem(tr("own"));
    showDisplay();
    Q_EMIT summaryChanged(summary());
}

void VolumePanel::showDisplay()
{
    const Workspace::VolumeDisplay& display = m_workspace.volumeDisplay();
    m_modes->button(int(display.mode))->setChecked(true);
    m_surfaceRow->setVisible(display.mode == gpu::RenderMode::Surface);
    const bool seesThrough = display.mode == gpu::RenderMode::Dvr;
    m_function->setVisible(seesThrough);
    m_preset->parentWidget()->setVisible(seesThrough);

    const QSignalBlocker slider(m_slider);
    const QSignalBlocker box(m_threshold);
    m_threshold->setValue(display.surfaceThreshold);
    const double range = m_threshold->maximum() - m_threshold->minimum();
    if (range > 0.0)
        m_slider->setValue(int(std::lround(
            (display.surfaceThreshold - m_threshold->minimum()) / range * sliderSteps)));
    m_function->setFunction(display.transferFunction);

    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return;
    const auto transfers = transferPresets(*volume);
    const auto windows = windowPresets(*volume);
    const auto transfer = std::find_if(transfers.begin(), transfers.end(),
        [&display](const TransferPreset& p) { return p.function == display.transferFunction; });
    m_preset->setCurrentIndex(int(transfer - transfers.begin()));
    const auto window = std::find_if(windows.begin(), windows.end(),
        [this](const WindowPreset& p) { return p.window == m_workspace.windowLevel(); });
    m_window->setCurrentIndex(int(window - windows.begin()));
}

void VolumePanel::takeMode(int mode)
{
    Workspace::VolumeDisplay display = m_workspace.volumeDisplay();
    display.mode = gpu::RenderMode(mode);
    m_workspace.setVolumeDisplay(display);
}

void VolumePanel::takeThreshold(double threshold)
{
    Workspace::VolumeDisplay display = m_workspace.volumeDisplay();
    display.surfaceThreshold = threshold;
    m_workspace.setVolumeDisplay(display);
}

void VolumePanel::takePreset(int row)
{
    const auto presets = transferPresets(*m_workspace.volume());
    if (row < int(presets.size())) {
        Workspace::VolumeDisplay display = m_workspace.volumeDisplay();
        display.transferFunction = presets[std::size_t(row)].function;
        m_workspace.setVolumeDisplay(display);
    }
    showDisplay(); // "own" cannot be chosen, only made
}

void VolumePanel::takeWindow(int row)
{
    const auto presets = windowPresets(*m_workspace.volume());
    if (row < int(presets.size()))
        m_workspace.setWindowLevel(presets[std::size_t(row)].window);
    showDisplay();
}

} // namespace ui
