// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourOptions.h"

#include "ui/base/Theme.h"
#include "ui/menus/EditableButton.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/tools/common/SeedOptions.h"
#include "ui/tools/contour/ContourTool.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>

namespace ui {

ContourOptions::ContourOptions(Workspace& workspace, ContourTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_tool(tool)
    , m_start(new QComboBox(this))
    , m_bubble(new NumberField(this))
    , m_pressure(pressureButton(this))
    , m_overwrite(new QCheckBox(tr("over others"), this))
{
    m_start->setObjectName(QStringLiteral("contourStart"));
    m_start->setFixedHeight(theme::controlHeight);
    m_start->addItem(tr("from a bubble"));
    m_start->addItem(tr("from bubbles"));
    m_start->addItem(tr("from the segment"));
    m_start->addItem(tr("from the seeds"));
    m_start->setToolTip(
        tr("With what the contour begins: a ball that is clicked, several of them (each click "
           "adds one; otherwise Shift+click does), the segment as it stands, or a ball around "
           "each of its sketched seeds that wait for a growth. With Ctrl or the pen's eraser "
           "end it erases: from the balls, or from all around the segment"));
    m_bubble->setObjectName(QStringLiteral("contourBubble"));
    m_bubble->setFixedHeight(theme::controlHeight);
    m_bubble->setKeyboardTracking(false);
    m_bubble->setRange(ContourSettings::minimumBubbleMm, ContourSettings::maximumBubbleMm);
    m_bubble->setDecimals(1);
    m_bubble->setSingleStep(0.5);
    m_bubble->setSuffix(tr(" mm"));
    m_bubble->setToolTip(tr("Radius of the bubble (Shift+wheel)"));
    m_pressure->setToolTip(
        tr("Pressure: radius, that is, a bubble becomes as large as the pen is pressed at most "
           "until it is lifted, up to the radius that is set; all bubbles of a contour are as "
           "large as its first one. Off: pressure does nothing, as with a mouse."));
    m_overwrite->setObjectName(QStringLiteral("contourOverwrite"));
    m_overwrite->setToolTip(tr("Over other segments that are not locked"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(new SeedOptions(workspace, {}, this));
    layout->addWidget(m_start);
    layout->addWidget(m_bubble);
    layout->addWidget(m_pressure);
    layout->addWidget(m_overwrite);
    layout->addWidget(new EditableButton(workspace, this));
    showSettings();
    connect(&tool, &ContourTool::settingsChanged, this, &ContourOptions::showSettings);
    connect(&workspace, &Workspace::brushSettingsChanged, this, &ContourOptions::showSettings);
    connect(m_start, &QComboBox::activated, this, &ContourOptions::takeSettings);
    connect(m_bubble, &QDoubleSpinBox::valueChanged, this, &ContourOptions::takeSettings);
    connect(m_pressure, &QToolButton::clicked, this, &ContourOptions::takeSettings);
    connect(m_overwrite, &QCheckBox::clicked, this, &ContourOptions::takeSettings);
}

void ContourOptions::showSettings()
{
    const QSignalBlocker start(m_start);
    const QSignalBlocker bubble(m_bubble);
    const QSignalBlocker overwrite(m_overwrite);
    m_start->setCurrentIndex(int(m_tool.settings().start));
    m_bubble->setValue(m_tool.settings().bubbleMm);
    m_pressure->setChecked(m_tool.settings().radiusByPressure);
    m_pressure->setEnabled(m_tool.settings().startsFromBubbles());
    m_overwrite->setChecked(m_workspace.brushSettings(Workspace::Brush::Paint).overwriteUnlocked);
}

void ContourOptions::takeSettings()
{
    ContourSettings now = m_tool.settings();
    now.start = ContourSettings::Start(m_start->currentIndex());
    now.bubbleMm = m_bubble->value();
    now.radiusByPressure = m_pressure->isChecked();
    // It is the same choice as for painting and outlines.
    Workspace::BrushSettings paint = m_workspace.brushSettings(Workspace::Brush::Paint);
    paint.overwriteUnlocked = m_overwrite->isChecked();
    m_workspace.setBrushSettings(Workspace::Brush::Paint, paint);
    m_tool.setSettings(now);
}

} // namespace ui
