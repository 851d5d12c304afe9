// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/PeelOptions.h"

#include "ui/base/Theme.h"
#include "ui/tools/sculpt/PeelTool.h"
#include "ui/widgets/fields/NumberField.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>

namespace ui {

namespace {

constexpr double stepsPerMm = 2.0;
constexpr int sliderPixels = 180;

} // namespace

PeelOptions::PeelOptions(PeelTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_tool(tool)
    , m_slider(new QSlider(Qt::Horizontal, this))
    , m_depth(new NumberField(this))
    , m_keep(new QPushButton(tr("Keep"), this))
    , m_through(new QCheckBox(tr("through gaps"), this))
    , m_jump(new NumberField(this))
{
    m_slider->setObjectName(QStringLiteral("peelSlider"));
    m_slider->setRange(
        int(PeelTool::minimumDepthMm * stepsPerMm), int(PeelTool::maximumDepthMm * stepsPerMm));
    m_slider->setFixedWidth(sliderPixels);
    m_depth->setObjectName(QStringLiteral("peelDepth"));
    m_depth->setRange(PeelTool::minimumDepthMm, PeelTool::maximumDepthMm);
    m_keep->setObjectName(QStringLiteral("peelKeep"));
    m_keep->setShortcut(QKeySequence(Qt::Key_Return));
    m_keep->setToolTip(tr("Keep this peel as a step (Enter)"));
    m_through->setObjectName(QStringLiteral("peelThroughGaps"));
    m_through->setToolTip(
        tr("Through gaps: peels on behind air or soft tissue up to the full depth"));
    m_jump->setObjectName(QStringLiteral("peelJump"));
    m_jump->setRange(0.0, PeelTool::maximumJumpMm);
    m_jump->setPrefix(tr("steps to "));
    m_jump->setSpecialValueText(tr("all surfaces"));
    m_jump->setToolTip(tr("Where the surface steps by more than this, what lies behind is another\n"
                          "surface, and only the largest one inside the curve is peeled"));
    for (QDoubleSpinBox* box : {m_depth, m_jump}) {
        box->setDecimals(1);
        box->setSingleStep(0.5);
        box->setSuffix(tr(" mm"));
        box->setFixedHeight(theme::controlHeight);
        box->setKeyboardTracking(false);
    }
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(new QLabel(tr("Depth"), this));
    layout->addWidget(m_slider);
    layout->addWidget(m_depth);
    layout->addWidget(m_keep);
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(m_through);
    layout->addWidget(m_jump);

    showSettings();
    connect(&tool, &PeelTool::changed, this, &PeelOptions::showSettings);
    connect(m_slider, &QSlider::valueChanged, this,
        [this](int steps) { m_tool.setDepthMm(steps / stepsPerMm); });
    connect(m_depth, &QDoubleSpinBox::valueChanged, &tool, &PeelTool::setDepthMm);
    connect(m_through, &QCheckBox::toggled, this, &PeelOptions::takeGaps);
    connect(m_jump, &QDoubleSpinBox::valueChanged, this, &PeelOptions::takeGaps);
    connect(m_keep, &QPushButton::clicked, &tool, &PeelTool::confirm);
}

void PeelOptions::showSettings()
{
    const QSignalBlocker slider(m_slider);
    const QSignalBlocker depth(m_depth);
    const QSignalBlocker through(m_through);
    const QSignalBlocker jump(m_jump);
    m_slider->setValue(int(std::lround(m_tool.depthMm() * stepsPerMm)));
    m_depth->setValue(m_tool.depthMm());
    m_through->setChecked(m_tool.gaps().through);
    m_jump->setValue(m_tool.gaps().jumpMm);
    m_keep->setEnabled(m_tool.isOpen());
}

void PeelOptions::takeGaps()
{
    m_tool.setGaps({.through = m_through->isChecked(), .jumpMm = m_jump->value()});
}

} // namespace ui
