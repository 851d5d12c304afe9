// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/EdgeOptions.h"

#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/widgets/fields/FieldMenu.h"
#include "ui/widgets/fields/NumberField.h"
#include "ui/widgets/fields/ValueField.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr auto edgeBrush = Workspace::Brush::Paint;

bool hasFractions(const core::Volume* volume)
{
    return volume && volume->maximum - volume->minimum < 50.0;
}

/// A tenth of the window: what looks about equally grey.
double firstTolerance(const Workspace& workspace)
{
    const double tenth = workspace.windowLevel().width / 10.0;
    return hasFractions(workspace.volume()) ? tenth : std::max(std::round(tenth), 1.0);
}

} // namespace

QString edgesText(const Workspace& workspace)
{
    const Workspace::BrushSettings& settings = workspace.brushSettings(edgeBrush);
    const core::Volume* volume = workspace.volume();
    if (!settings.followsEdges || !volume)
        return {};
    return QObject::tr("follows edges within ±%1")
        .arg(valueText(settings.edgeTolerance, volume->unit, volume->maximum - volume->minimum));
}

EdgeOptions::EdgeOptions(Workspace& workspace, QWidget* parent)
    : QToolButton(parent)
    , m_workspace(workspace)
{
    setObjectName(QStringLiteral("brushEdges"));
    setFixedHeight(theme::controlHeight);
    setPopupMode(QToolButton::InstantPopup);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setCheckable(true);
    // As short as it can be: the bar has no room.
    setText(tr("edges"));
    auto* content = new QWidget;
    m_follows = new QCheckBox(tr("follows edges on slices, within ±"), content);
    m_follows->setObjectName(QStringLiteral("brushFollowsEdges"));
    m_follows->setToolTip(
        tr("Only what is joined to the pen under the brush and differs by no more "
           "than this from the value where the stroke begins. In 3D it does "
           "nothing."));
    m_tolerance = new NumberField(content);
    m_tolerance->setObjectName(QStringLiteral("brushEdgeTolerance"));
    m_tolerance->setFixedHeight(theme::controlHeight);
    m_tolerance->setKeyboardTracking(false);
    m_tolerance->setRange(0.0, Workspace::BrushSettings::greatestEdgeTolerance);
    m_byPressure = new QCheckBox(tr("less of it where a pen is pressed less"), content);
    m_byPressure->setObjectName(QStringLiteral("brushTolerancePressure"));
    m_byPressure->setToolTip(tr("Pressure: tolerance. Lightly pressed the brush takes only what is "
                                "most alike; the radius stays whole."));
    auto* row = new QHBoxLayout;
    row->setSpacing(theme::smallPadding);
    row->addWidget(m_follows);
    row->addWidget(m_tolerance);
    auto* rows = new QVBoxLayout(content);
    rows->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    rows->setSpacing(theme::smallPadding);
    rows->addLayout(row);
    rows->addWidget(m_byPressure);
    setMenu(new FieldMenu(content, this));

    showSettings();
    connect(&m_workspace, &Workspace::brushSettingsChanged, this, &EdgeOptions::showSettings);
    connect(m_follows, &QCheckBox::clicked, this, &EdgeOptions::takeSwitch);
    connect(m_tolerance, &QDoubleSpinBox::valueChanged, this, &EdgeOptions::takeTolerance);
    connect(m_byPressure, &QCheckBox::clicked, this, &EdgeOptions::takePressure);
}

void EdgeOptions::showSettings()
{
    const Workspace::BrushSettings& settings = m_workspace.brushSettings(edgeBrush);
    const core::Volume* volume = m_workspace.volume();
    const QSignalBlocker blocker(m_tolerance);
    m_tolerance->setDecimals(volume ? valueFieldDecimals(volume->maximum - volume->minimum) : 0);
    m_tolerance->setSuffix(volume ? QLatin1Char(' ') + volume->unit : QString());
    m_tolerance->setValue(settings.edgeTolerance);
    m_tolerance->setEnabled(settings.followsEdges);
    m_follows->setChecked(settings.followsEdges);
    m_byPressure->setChecked(settings.toleranceByPressure);
    m_byPressure->setEnabled(settings.followsEdges);
    setChecked(settings.followsEdges);
    const QString text = edgesText(m_workspace);
    setToolTip(text.isEmpty() ? tr("Whether the brush follows edges on slices")
                              : tr("On slices the brush %1").arg(text));
}

void EdgeOptions::takeSwitch()
{
    Workspace::BrushSettings settings = m_workspace.brushSettings(edgeBrush);
    settings.followsEdges = m_follows->isChecked();
    if (settings.followsEdges && !(settings.edgeTolerance > 0.0))
        settings.edgeTolerance = firstTolerance(m_workspace);
    m_workspace.setBrushSettings(edgeBrush, settings);
}

void EdgeOptions::takeTolerance()
{
    Workspace::BrushSettings settings = m_workspace.brushSettings(edgeBrush);
    settings.edgeTolerance = m_tolerance->value();
    m_workspace.setBrushSettings(edgeBrush, settings);
}

void EdgeOptions::takePressure()
{
    Workspace::BrushSettings settings = m_workspace.brushSettings(edgeBrush);
    settings.toleranceByPressure = m_byPressure->isChecked();
    m_workspace.setBrushSettings(edgeBrush, settings);
}

} // namespace ui
