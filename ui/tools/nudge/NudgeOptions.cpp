// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/nudge/NudgeOptions.h"

#include "ui/base/Theme.h"
#include "ui/tools/common/BrushTool.h"
#include "ui/tools/common/PaintLimits.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/tools/common/SeedOptions.h"
#include "ui/tools/nudge/NudgeTool.h"
#include "ui/widgets/fields/NumberField.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

namespace ui {

NudgeOptions::NudgeOptions(Workspace& workspace, NudgeTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_tool(tool)
    , m_radius(new NumberField(this))
    , m_fits(new QCheckBox(tr("fit to border"), this))
    , m_pressure(pressureButton(this))
{
    m_radius->setObjectName(QStringLiteral("nudgeRadius"));
    m_radius->setFixedHeight(theme::controlHeight);
    m_radius->setKeyboardTracking(false);
    m_radius->setRange(BrushTool::minimumRadiusMm, BrushTool::maximumRadiusMm);
    m_radius->setDecimals(1);
    m_radius->setSingleStep(0.5);
    m_radius->setSuffix(tr(" mm"));
    m_fits->setObjectName(QStringLiteral("nudgeFits"));
    m_fits->setToolTip(tr("The disc is no larger than the distance to the border where it is "
                          "pressed, so that nothing changes before it is pushed against it"));

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(new SeedOptions(workspace, {}, this));
    layout->addWidget(new QLabel(tr("Radius"), this));
    layout->addWidget(m_radius);
    layout->addWidget(m_fits);
    layout->addWidget(m_pressure);
    layout->addWidget(new PaintLimits(workspace, this));

    showSettings();
    connect(&m_tool, &NudgeTool::settingsChanged, this, &NudgeOptions::showSettings);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, &NudgeOptions::takeSettings);
    connect(m_fits, &QCheckBox::clicked, this, &NudgeOptions::takeSettings);
    connect(m_pressure, &QToolButton::clicked, this, &NudgeOptions::takeSettings);
}

void NudgeOptions::showSettings()
{
    const QSignalBlocker radius(m_radius);
    m_radius->setValue(m_tool.settings().radiusMm);
    m_fits->setChecked(m_tool.settings().fits);
    m_pressure->setChecked(m_tool.settings().radiusByPressure);
}

void NudgeOptions::takeSettings()
{
    m_tool.setSettings({.radiusMm = m_radius->value(),
        .fits = m_fits->isChecked(),
        .radiusByPressure = m_pressure->isChecked()});
}

} // namespace ui
