// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/PlaneOptions.h"

#include "ui/base/Theme.h"
#include "ui/tools/view/CuttingPlaneTool.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <cmath>

namespace ui {

PlaneOptions::PlaneOptions(Workspace& workspace, CuttingPlaneTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_tool(tool)
    , m_clips(new QCheckBox(tr("Clip above"), this))
    , m_opacity(new QSlider(Qt::Horizontal, this))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    const auto add = [&](const QString& text, const char* name, const QString& tip) {
        auto* button = new QToolButton(this);
        button->setObjectName(QLatin1String(name));
        button->setText(text);
        button->setToolTip(tip);
        button->setFixedHeight(theme::controlHeight);
        layout->addWidget(button);
        return button;
    };
    CuttingPlane& plane = workspace.plane();
    const auto addSide = [&](const QString& text, const char* name, SliceOrientation side) {
        connect(add(text, name, tr("Through the crosshair, as in this slice")),
            &QToolButton::clicked, this, [&plane, side] { plane.align(side); });
    };
    addSide(tr("Axial"), "planeAxial", SliceOrientation::Axial);
    addSide(tr("Sagittal"), "planeSagittal", SliceOrientation::Sagittal);
    addSide(tr("Coronal"), "planeCoronal", SliceOrientation::Coronal);
    connect(add(tr("Flip"), "planeFlip", tr("Seen from its other side")), &QToolButton::clicked,
        &plane, &CuttingPlane::flip);
    m_threePoints = add(tr("3 points"), "planeThreePoints",
        tr("Through three places that are clicked on, in any view"));
    m_across = add(tr("Across"), "planeAcross",
        tr("Across the vessel, or upright on the surface, that is clicked on"));
    for (QToolButton* button : {m_threePoints, m_across})
        button->setCheckable(true);
    connect(m_threePoints, &QToolButton::clicked, &tool, [&tool](bool on) {
        tool.setAim(on ? CuttingPlaneTool::Aim::ThreePoints : CuttingPlaneTool::Aim::Handles);
    });
    connect(m_across, &QToolButton::clicked, &tool, [&tool](bool on) {
        tool.setAim(on ? CuttingPlaneTool::Aim::Across : CuttingPlaneTool::Aim::Handles);
    });
    m_clips->setObjectName(QStringLiteral("planeClips"));
    m_clips->setToolTip(
        tr("Hide in 3D what lies above the plane: on the side it is looked at from"));
    layout->addWidget(m_clips);
    layout->addWidget(new QLabel(tr("Opacity"), this));
    m_opacity->setObjectName(QStringLiteral("planeOpacity"));
    m_opacity->setAccessibleName(tr("Opacity"));
    m_opacity->setRange(0, 100);
    m_opacity->setFixedWidth(90);
    layout->addWidget(m_opacity);

    showPlane();
    showAim();
    connect(&plane, &CuttingPlane::changed, this, &PlaneOptions::showPlane);
    connect(&tool, &CuttingPlaneTool::aimChanged, this, &PlaneOptions::showAim);
    connect(m_clips, &QCheckBox::toggled, this, &PlaneOptions::takeLook);
    connect(m_opacity, &QSlider::valueChanged, this, &PlaneOptions::takeLook);
}

void PlaneOptions::showPlane()
{
    const CuttingPlane::Look& look = m_workspace.plane().look();
    const QSignalBlocker clips(m_clips);
    const QSignalBlocker opacity(m_opacity);
    m_clips->setChecked(look.clipsAbove);
    m_opacity->setValue(int(std::lround(100.0f * look.opacity)));
}

void PlaneOptions::showAim()
{
    m_threePoints->setChecked(m_tool.aim() == CuttingPlaneTool::Aim::ThreePoints);
    m_across->setChecked(m_tool.aim() == CuttingPlaneTool::Aim::Across);
}

void PlaneOptions::takeLook()
{
    CuttingPlane::Look look = m_workspace.plane().look();
    look.clipsAbove = m_clips->isChecked();
    look.opacity = float(m_opacity->value()) / 100.0f;
    m_workspace.plane().setLook(look);
}

} // namespace ui
