// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/DrillOptions.h"

#include "ui/Theme.h"
#include "ui/Workspace.h"
#include "ui/tools/DrillSurface.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace ui {

namespace {

QDoubleSpinBox* millimetreBox(QWidget* parent, double minimum, double maximum, const QString& name)
{
    auto* box = new QDoubleSpinBox(parent);
    box->setObjectName(name);
    box->setRange(minimum, maximum);
    box->setDecimals(1);
    box->setSingleStep(0.5);
    box->setSuffix(QObject::tr(" mm"));
    box->setFixedHeight(theme::controlHeight);
    box->setKeyboardTracking(false);
    return box;
}

} // namespace

DrillOptions::DrillOptions(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_radius(millimetreBox(this, minimumRadiusMm, maximumRadiusMm, QStringLiteral("drillRadius")))
    , m_depth(millimetreBox(this, minimumDepthMm, maximumDepthMm, QStringLiteral("drillDepth")))
    , m_throughGaps(new QCheckBox(tr("through gaps"), this))
    , m_start(new QLabel(this))
{
    m_throughGaps->setObjectName(QStringLiteral("drillThroughGaps"));
    m_throughGaps->setToolTip(tr("Cut on behind air or soft tissue up to the full depth"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(new QLabel(tr("Radius"), this));
    layout->addWidget(m_radius);
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(new QLabel(tr("Depth"), this));
    m_depth->setToolTip(tr("At full pressure; half the pressure cuts a quarter of it"));
    layout->addWidget(m_depth);
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(m_throughGaps);
    m_start->setObjectName(QStringLiteral("drillStart"));
    m_start->setProperty("role", QStringLiteral("secondary"));
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(m_start);

    showSettings();
    connect(&m_workspace, &Workspace::drillSettingsChanged, this, &DrillOptions::showSettings);
    connect(&m_workspace, &Workspace::volumeDisplayChanged, this, &DrillOptions::showSettings);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, &DrillOptions::takeSettings);
    connect(m_depth, &QDoubleSpinBox::valueChanged, this, &DrillOptions::takeSettings);
    connect(m_throughGaps, &QCheckBox::toggled, this, &DrillOptions::takeSettings);
}

void DrillOptions::showSettings()
{
    const QSignalBlocker radius(m_radius);
    const QSignalBlocker depth(m_depth);
    const QSignalBlocker gaps(m_throughGaps);
    m_radius->setValue(m_workspace.drillSettings().radiusMm);
    m_depth->setValue(m_workspace.drillSettings().depthMm);
    m_throughGaps->setChecked(m_workspace.drillSettings().throughGaps);
    const core::Volume* volume = m_workspace.volume();
    m_start->setText(volume ? startText(m_workspace) : QString());
    switch (m_workspace.volumeDisplay().mode) {
    case gpu::RenderMode::Surface:
        m_start->setToolTip(tr("A cut starts at the surface that is shown"));
        break;
    case gpu::RenderMode::Dvr:
        m_start->setToolTip(tr("A cut starts where the picture becomes opaque"));
        break;
    case gpu::RenderMode::Mip:
        m_start->setToolTip(tr("Maximum intensity shows no surface: a cut starts at that of the "
                               "surface mode"));
        break;
    case gpu::RenderMode::Xray:
        m_start->setToolTip(
            tr("An X-ray shows no surface: a cut starts at that of the surface mode"));
        break;
    }
}

void DrillOptions::takeSettings()
{
    m_workspace.setDrillSettings({m_radius->value(), m_depth->value(), m_throughGaps->isChecked()});
}

} // namespace ui
