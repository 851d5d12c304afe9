// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/DrillOptions.h"

#include "core/edits/kinds/sculpt/ToolMask.h"
#include "core/edits/kinds/sculpt/ToolMasks.h"
#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/tools/aim/DrillMask.h"
#include "ui/tools/aim/DrillSurface.h"
#include "ui/tools/common/PenMenu.h"
#include "ui/tools/sculpt/ToolMaskPresetMenu.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/widgets/fields/NumberField.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>

namespace ui {

namespace {

QDoubleSpinBox* millimetreBox(QWidget* parent, double minimum, double maximum, const QString& name)
{
    auto* box = new NumberField(parent);
    box->setObjectName(name);
    box->setRange(minimum, maximum);
    box->setDecimals(1);
    box->setSingleStep(0.5);
    box->setSuffix(QObject::tr(" mm"));
    box->setFixedHeight(theme::controlHeight);
    box->setKeyboardTracking(false);
    return box;
}

/// Behind the shapes that core knows.
constexpr int freehandIndex = int(core::ToolMask::Kind::Rounded) + 1;
constexpr int iconPixels = 18;

/// The outline as it would be pressed, however large, small.
QIcon outlineIcon(const Workspace::DrillSettings& settings, double devicePixelRatio)
{
    if (settings.outline.empty())
        return {};
    QPixmap picture(QSize(iconPixels, iconPixels) * devicePixelRatio);
    picture.setDevicePixelRatio(devicePixelRatio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const core::ToolMask mask = drillMask(settings);
    const double half = 0.5 * iconPixels;
    painter.setPen(QPen(theme::text, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(theme::selected);
    painter.drawPolygon(maskOutline(mask, QPointF(half, half), core::reachMm(mask) / (half - 1.0)),
        Qt::WindingFill);
    return QIcon(picture);
}

} // namespace

DrillOptions::DrillOptions(Workspace& workspace, Of tool, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_tool(tool)
    , m_shape(new QComboBox(this))
    , m_outline(new QToolButton(this))
    , m_radius(millimetreBox(this, minimumRadiusMm, maximumRadiusMm, QStringLiteral("drillRadius")))
    , m_height(new NumberField(this))
    , m_turn(new NumberField(this))
    , m_softness(millimetreBox(this, 0.0, maximumSoftnessMm, QStringLiteral("drillSoftness")))
    , m_mode(new QComboBox(this))
    , m_depth(millimetreBox(this, minimumDepthMm, maximumDepthMm, QStringLiteral("drillDepth")))
    , m_floor(millimetreBox(this, minimumFloorMm, maximumFloorMm, QStringLiteral("drillFloor")))
    , m_sweep(new QComboBox(this))
    , m_throughGaps(new QCheckBox(tr("gaps"), this))
    , m_radiusLabel(new QLabel(tr("Radius"), this))
    , m_start(new FittingLabel(Qt::AlignLeft, this))
{
    // In the order of the enumerators.
    m_shape->setObjectName(QStringLiteral("drillShape"));
    m_shape->addItems({tr("Circle"), tr("Ellipse"), tr("Square"), tr("Rectangle"), tr("Rounded"),
        tr("Freehand")});
    m_shape->setToolTip(tr("What is pressed into the volume"));
    m_outline->setObjectName(QStringLiteral("drillOutline"));
    m_outline->setText(tr("Draw"));
    m_outline->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_outline->setCheckable(true);
    m_outline->setIconSize(QSize(iconPixels, iconPixels));
    m_outline->setFixedHeight(theme::controlHeight);
    m_outline->setFocusPolicy(Qt::TabFocus);
    m_outline->setToolTip(tr("The next drag in the 3D view draws the mask; it closes by itself"));
    m_mode->setObjectName(QStringLiteral("drillMode"));
    m_mode->addItems({tr("Limit"), tr("Rate")});
    m_mode->setToolTip(tr("Limit: one press cuts at most the depth, however long it lasts\n"
                          "Rate: it cuts so much a second, down to a floor"));
    m_sweep->setObjectName(QStringLiteral("drillSweep"));
    m_sweep->addItems({tr("View"), tr("Normal"), tr("L – R"), tr("A – P"), tr("S – I"), tr("Pen")});
    m_sweep->setToolTip(tr("Which way the drill goes in; settled when the pen goes down\n"
                           "View: along the line of sight\n"
                           "Normal: across the surface under the pen\n"
                           "L – R, A – P, S – I: along that axis of the patient\n"
                           "Pen: the way its tip points"));
    m_height->setObjectName(QStringLiteral("drillHeight"));
    m_height->setRange(100.0 * minimumHeightRatio, 100.0);
    m_height->setDecimals(0);
    m_height->setSingleStep(5.0);
    m_height->setSuffix(tr(" %"));
    m_height->setToolTip(tr("Height of the mask, in per cent of its width"));
    m_turn->setObjectName(QStringLiteral("drillTurn"));
    m_turn->setRange(-180.0, 180.0);
    m_turn->setWrapping(true);
    m_turn->setDecimals(0);
    m_turn->setSingleStep(5.0);
    m_turn->setSuffix(QStringLiteral("°"));
    m_turn->setToolTip(tr("Turned counter-clockwise"));
    m_softness->setPrefix(tr("soft "));
    m_softness->setSpecialValueText(tr("sharp"));
    m_softness->setToolTip(tr("The mask's edge: sharp, or over so much from it inwards\n"
                              "the depth rises to its full value"));
    for (QDoubleSpinBox* box : {m_height, m_turn}) {
        box->setFixedHeight(theme::controlHeight);
        box->setKeyboardTracking(false);
    }
    for (QComboBox* box : {m_shape, m_mode, m_sweep})
        box->setFixedHeight(theme::controlHeight);
    m_throughGaps->setObjectName(QStringLiteral("drillThroughGaps"));
    m_throughGaps->setToolTip(
        tr("Through gaps: cut on behind air or soft tissue up to the full depth"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_shape);
    layout->addWidget(m_outline);
    layout->addWidget(new ToolMaskPresetMenu(workspace, this));
    layout->addWidget(m_radiusLabel);
    layout->addWidget(m_radius);
    layout->addWidget(m_height);
    layout->addWidget(m_turn);
    layout->addWidget(m_softness);
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(m_mode);
    m_depth->setToolTip(tr("At full pressure"));
    layout->addWidget(m_depth);
    m_floor->setPrefix(tr("to "));
    m_floor->setToolTip(tr("The floor: no deeper than this below the surface"));
    layout->addWidget(m_floor);
    layout->addWidget(new PenMenu(workspace, this));
    layout->addSpacing(theme::smallPadding);
    layout->addWidget(m_sweep);
    m_sweep->setVisible(!ofLaser());
    layout->addWidget(m_throughGaps);
    m_start->setObjectName(QStringLiteral("drillStart"));
    m_start->setProperty("role", QStringLiteral("secondary"));
    layout->addSpacing(theme::smallPadding);
    // Tells what room there is: the options never make the window wider.
    m_start->setMinimumWidth(1);
    m_start->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_start->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    layout->addWidget(m_start, 1);
    m_radius->setFixedWidth(84);
    m_height->setFixedWidth(62);
    m_turn->setFixedWidth(58);
    m_softness->setFixedWidth(106);
    m_floor->setFixedWidth(104);

    showSettings();
    connect(&m_workspace, &Workspace::drillSettingsChanged, this, &DrillOptions::showSettings);
    connect(&m_workspace, &Workspace::volumeDisplayChanged, this, &DrillOptions::showSettings);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, &DrillOptions::takeSettings);
    connect(m_depth, &QDoubleSpinBox::valueChanged, this, &DrillOptions::takeSettings);
    connect(m_floor, &QDoubleSpinBox::valueChanged, this, &DrillOptions::takeSettings);
    for (const QDoubleSpinBox* box : {m_height, m_turn, m_softness})
        connect(box, &QDoubleSpinBox::valueChanged, this, &DrillOptions::takeSettings);
    for (const QComboBox* box : {m_mode, m_sweep})
        connect(box, &QComboBox::currentIndexChanged, this, &DrillOptions::takeSettings);
    connect(m_shape, &QComboBox::currentIndexChanged, this, &DrillOptions::takeShape);
    connect(m_outline, &QToolButton::clicked, this, &DrillOptions::outlineRequested);
    connect(m_throughGaps, &QCheckBox::toggled, this, &DrillOptions::takeSettings);
}

void DrillOptions::showSettings()
{
    const QSignalBlocker radius(m_radius);
    const QSignalBlocker depth(m_depth);
    const QSignalBlocker gaps(m_throughGaps);
    const QSignalBlocker shape(m_shape);
    const QSignalBlocker height(m_height);
    const QSignalBlocker turn(m_turn);
    const QSignalBlocker softness(m_softness);
    const QSignalBlocker mode(m_mode);
    const QSignalBlocker floor(m_floor);
    const QSignalBlocker sweep(m_sweep);
    const Workspace::DrillSettings& settings = m_workspace.drillSettings();
    m_radius->setValue(settings.radiusMm);
    m_depth->setValue(ofLaser() ? settings.laserDepthMm : settings.depthMm);
    m_floor->setValue(settings.floorMm);
    m_floor->setVisible(settings.mode == core::DrillMode::Rate);
    m_throughGaps->setChecked(settings.throughGaps);
    m_shape->setCurrentIndex(settings.freehand ? freehandIndex : int(settings.shape));
    m_height->setValue(100.0 * settings.heightRatio);
    m_turn->setValue(settings.rotationDegrees);
    m_softness->setValue(settings.softnessMm);
    m_mode->setCurrentIndex(int(settings.mode));
    m_sweep->setCurrentIndex(int(settings.sweep));
    showSize();
    const bool rate = settings.mode == core::DrillMode::Rate;
    m_depth->setSuffix(rate ? tr(" mm/s") : tr(" mm"));
    m_depth->setFixedWidth(rate ? 98 : 84);
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
                               "isosurface"));
        break;
    case gpu::RenderMode::Xray:
        m_start->setToolTip(
            tr("An X-ray shows no surface: a cut starts at that of the isosurface"));
        break;
    }
}

/// What there is to set of the shape.
void DrillOptions::showSize()
{
    using Kind = core::ToolMask::Kind;
    const Workspace::DrillSettings& settings = m_workspace.drillSettings();
    // Of all shapes that are not round the radius is half the width.
    const bool round = settings.shape == Kind::Circle && !settings.freehand;
    m_radiusLabel->setVisible(round);
    m_radius->setPrefix(round ? QString() : QStringLiteral("±"));
    m_radius->setToolTip(round  ? tr("Radius of the mask")
            : settings.freehand ? tr("Half the length of the outline, as it was drawn or scaled")
                                : tr("Half the width of the mask"));
    m_height->setVisible(!round && !settings.freehand && settings.shape != Kind::Square);
    m_turn->setVisible(!round);
    m_outline->setVisible(settings.freehand);
    m_outline->setIcon(outlineIcon(settings, devicePixelRatioF()));
}

void DrillOptions::showDrawing(bool drawing)
{
    m_outline->setChecked(drawing);
}

QString DrillOptions::sizeText(const Workspace::DrillSettings& settings)
{
    const bool round = settings.shape == core::ToolMask::Kind::Circle && !settings.freehand;
    const QString mm = numberText(round ? settings.radiusMm : 2.0 * settings.radiusMm, 1);
    if (round)
        return tr("radius %1 mm").arg(mm);
    return settings.freehand ? tr("%1 mm across").arg(mm) : tr("width %1 mm").arg(mm);
}

void DrillOptions::takeShape(int index)
{
    Workspace::DrillSettings settings = m_workspace.drillSettings();
    settings.freehand = index == freehandIndex;
    if (!settings.freehand)
        settings.shape = core::ToolMask::Kind(index);
    m_workspace.setDrillSettings(settings);
    if (settings.freehand && settings.outline.empty())
        Q_EMIT outlineRequested(true);
}

void DrillOptions::takeSettings()
{
    Workspace::DrillSettings settings = m_workspace.drillSettings();
    settings.radiusMm = m_radius->value();
    (ofLaser() ? settings.laserDepthMm : settings.depthMm) = m_depth->value();
    settings.floorMm = m_floor->value();
    settings.throughGaps = m_throughGaps->isChecked();
    settings.heightRatio = m_height->value() / 100.0;
    settings.rotationDegrees = m_turn->value();
    settings.softnessMm = m_softness->value();
    settings.mode = core::DrillMode(m_mode->currentIndex());
    settings.sweep = Workspace::Sweep(m_sweep->currentIndex());
    m_workspace.setDrillSettings(settings);
}

} // namespace ui
