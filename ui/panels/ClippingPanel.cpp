// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/ClippingPanel.h"

#include "ui/base/Icons.h"
#include "ui/base/NumberText.h"
#include "ui/base/SmallLabel.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/views/VolumeView.h"
#include "ui/widgets/RangeSlider.h"
#include "ui/workspace/ViewSteps.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double stepsPerMm = 10.0;

QToolButton* smallButton(QWidget* parent, const char* icon, const QString& tip)
{
    auto* button = new QToolButton(parent);
    button->setIcon(stateIcon(QLatin1String(icon)));
    button->setIconSize(QSize(16, 16));
    button->setFixedSize(22, theme::controlHeight);
    button->setStyleSheet(QStringLiteral("padding: 0"));
    button->setAutoRaise(true);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    return button;
}

glm::dvec3 middleOf(const core::VolumeGeometry& geometry)
{
    return geometry.toWorld(0.5 * glm::dvec3(geometry.size - 1));
}

/// How far the volume reaches from its middle along a direction.
double reachOf(const core::VolumeGeometry& geometry, const glm::dvec3& direction)
{
    double reach = 0.0;
    for (const glm::dvec3& corner : geometry.cornersLps())
        reach = std::max(reach, std::abs(glm::dot(corner - middleOf(geometry), direction)));
    return reach;
}

} // namespace

ClippingPanel::ClippingPanel(Workspace& workspace, VolumeView& view, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_view(view)
{
    build();
    connect(m_box, &QCheckBox::toggled, this, &ClippingPanel::takeBox);
    connect(m_reset, &QToolButton::clicked, this, &ClippingPanel::reset);
    connect(m_faces, &QComboBox::activated, this, [this](int row) {
        Workspace::VolumeDisplay display = m_workspace.volumeDisplay();
        display.cutFaces = gpu::CutFaces(row);
        m_workspace.setVolumeDisplay(display);
    });
    connect(&workspace, &Workspace::sessionChanged, this, &ClippingPanel::showVolume);
    connect(&workspace, &Workspace::clipChanged, this, &ClippingPanel::showClip);
    connect(&workspace, &Workspace::volumeDisplayChanged, this, &ClippingPanel::showClip);
    showVolume();
}

void ClippingPanel::build()
{
    m_box = new QCheckBox(tr("Clip box"), this);
    m_box->setObjectName(QStringLiteral("clipBox"));
    m_reset = new QToolButton(this);
    m_reset->setText(tr("Reset"));
    m_reset->setObjectName(QStringLiteral("clipReset"));
    m_reset->setToolTip(tr("Show the whole volume: box and planes off"));
    auto* head = new QHBoxLayout;
    head->addWidget(m_box, 1);
    head->addWidget(m_reset);

    auto* axes = new QGridLayout;
    axes->setHorizontalSpacing(4);
    axes->setVerticalSpacing(2);
    m_axes.build(this, *axes, QStringLiteral("clipAxis"));
    for (int axis = 0; axis < 3; ++axis) {
        QLabel*& text = m_axisTexts[std::size_t(axis)];
        text = smallNote({}, this, Qt::AlignRight);
        text->setMinimumWidth(82);
        axes->addWidget(text, axis, 3);
        connect(m_axes.of(axis), &RangeSlider::valuesEdited, this,
            [this, axis](double lower, double upper) { takeAxis(axis, lower, upper); });
    }

    auto* planes = new QGridLayout;
    planes->setHorizontalSpacing(2);
    planes->setVerticalSpacing(2);
    for (std::size_t i = 0; i < m_planes.size(); ++i) {
        PlaneRow& row = m_planes[i];
        const int line = int(i);
        row.on = new QCheckBox(QString::number(i + 1), this);
        row.on->setAccessibleName(tr("Plane %1").arg(i + 1));
        row.on->setObjectName(QStringLiteral("clipPlane%1").arg(i));
        row.on->setToolTip(
            tr("A new plane passes through the crosshair and hides what lies before it"));
        row.offset = new QSlider(Qt::Horizontal, this);
        row.offset->setObjectName(QStringLiteral("clipOffset%1").arg(i));
        row.offset->setAccessibleName(tr("Offset of plane %1").arg(i + 1));
        row.offset->setMinimumWidth(40);
        row.text = smallNote({}, this, Qt::AlignRight);
        row.text->setMinimumWidth(54);
        row.place = smallButton(this, "aim", tr("Through the crosshair, facing the viewer"));
        row.place->setObjectName(QStringLiteral("clipPlace%1").arg(i));
        row.flip = smallButton(this, "flip", tr("Hide the other side"));
        row.flip->setObjectName(QStringLiteral("clipFlip%1").arg(i));
        row.look = smallButton(this, "eye", tr("Look straight at the cut"));
        row.look->setObjectName(QStringLiteral("clipLook%1").arg(i));
        planes->addWidget(row.on, line, 0);
        planes->addWidget(row.offset, line, 1);
        planes->addWidget(row.text, line, 2);
        planes->addWidget(row.place, line, 3);
        planes->addWidget(row.flip, line, 4);
        planes->addWidget(row.look, line, 5);
        connect(row.on, &QCheckBox::toggled, this, [this, i](bool on) {
            core::ClipPlane plane = m_workspace.clip().planes[i];
            const bool fresh = plane == core::ClipPlane{};
            plane.on = on;
            if (on && fresh)
                place(i);
            else
                change(i, plane);
        });
        connect(row.offset, &QSlider::valueChanged, this,
            [this, i](int step) { takeOffset(i, step / stepsPerMm); });
        connect(row.place, &QToolButton::clicked, this, [this, i] { place(i); });
        connect(row.flip, &QToolButton::clicked, this, [this, i] {
            core::ClipPlane plane = m_workspace.clip().planes[i];
            plane.normalLps = -plane.normalLps;
            change(i, plane);
        });
        connect(row.look, &QToolButton::clicked, this,
            [this, i] { m_view.lookFrom(m_workspace.clip().planes[i].normalLps); });
    }
    planes->setColumnStretch(1, 1);

    m_faces = new QComboBox(this);
    m_faces->setObjectName(QStringLiteral("cutFaces"));
    m_faces->addItems({tr("Material colour"), tr("Grey values")}); // in the order of gpu::CutFaces
    m_faces->setFixedHeight(theme::controlHeight);
    m_faces->setToolTip(tr("How isosurface and volume rendering show what a cut lays open: in "
                           "the colours of the transfer function, or grey as in the slices"));
    auto* faces = new QHBoxLayout;
    faces->addWidget(smallNote(tr("Cut faces"), this));
    faces->addWidget(m_faces, 1);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(theme::padding, theme::smallPadding, theme::padding, theme::padding);
    layout->setSpacing(6);
    layout->addLayout(head);
    layout->addLayout(axes);
    layout->addWidget(smallNote(tr("Planes"), this));
    layout->addLayout(planes);
    layout->addLayout(faces);
}

QString ClippingPanel::title() const
{
    return tr("Clipping");
}

QString ClippingPanel::summary() const
{
    const core::ClipRegion& clip = m_workspace.clip();
    const auto planes = std::count_if(clip.planes.begin(), clip.planes.end(),
        [](const core::ClipPlane& plane) { return plane.on; });
    QStringList parts;
    if (clip.box.on)
        parts += tr("box");
    if (planes > 0)
        parts += planes == 1 ? tr("1 plane") : tr("%1 planes").arg(planes);
    return parts.join(QStringLiteral(" · "));
}

void ClippingPanel::showVolume()
{
    const core::Volume* volume = m_workspace.volume();
    setEnabled(volume != nullptr);
    if (volume)
        m_axes.showVolume(volume->geometry);
    showClip();
}

double ClippingPanel::offsetOf(const core::ClipPlane& plane) const
{
    return glm::dot(plane.pointLps - middleOf(m_workspace.volume()->geometry), plane.normalLps);
}

void ClippingPanel::showClip()
{
    Q_EMIT summaryChanged(summary());
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return;
    const core::ClipRegion& clip = m_workspace.clip();
    const QSignalBlocker boxBlocker(m_box);
    m_box->setChecked(clip.box.on);
    m_reset->setEnabled(clip != core::wholeVolume(volume->geometry));
    m_axes.showBox(clip.box, volume->geometry);
    for (int axis = 0; axis < 3; ++axis) {
        const RangeSlider& slider = *m_axes.of(axis);
        m_axisTexts[std::size_t(axis)]->setText(
            tr("%1 – %2 mm").arg(numberText(slider.lower(), 0), numberText(slider.upper(), 0)));
    }
    for (std::size_t i = 0; i < m_planes.size(); ++i) {
        const core::ClipPlane& plane = clip.planes[i];
        PlaneRow& row = m_planes[i];
        const QSignalBlocker on(row.on);
        const QSignalBlocker offset(row.offset);
        row.on->setChecked(plane.on);
        const int reach = int(std::ceil(reachOf(volume->geometry, plane.normalLps) * stepsPerMm));
        row.offset->setRange(-reach, reach);
        row.offset->setValue(int(std::lround(offsetOf(plane) * stepsPerMm)));
        row.text->setText(plane.on ? tr("%1 mm").arg(numberText(offsetOf(plane), 1)) : QString());
        for (QWidget* part : {static_cast<QWidget*>(row.offset), static_cast<QWidget*>(row.flip),
                 static_cast<QWidget*>(row.look)})
            part->setEnabled(plane.on);
    }
    m_faces->setCurrentIndex(int(m_workspace.volumeDisplay().cutFaces));
}

void ClippingPanel::takeBox(bool on)
{
    core::ClipRegion clip = m_workspace.clip();
    clip.box.on = on;
    m_workspace.viewSteps().change(clip);
}

void ClippingPanel::takeAxis(int axis, double lower, double upper)
{
    const double spacing = m_workspace.volume()->geometry.spacingMm()[axis];
    core::ClipRegion clip = m_workspace.clip();
    clip.box.minimum[axis] = lower / spacing - 0.5;
    clip.box.maximum[axis] = upper / spacing - 0.5;
    clip.box.on = true;
    m_workspace.viewSteps().change(clip);
}

void ClippingPanel::takeOffset(std::size_t row, double offsetMm)
{
    core::ClipPlane plane = m_workspace.clip().planes[row];
    plane.pointLps += (offsetMm - offsetOf(plane)) * plane.normalLps;
    change(row, plane);
}

void ClippingPanel::place(std::size_t row)
{
    change(row,
        {.pointLps = m_workspace.crosshairLps(),
            .normalLps = m_view.camera().towardsViewer,
            .on = true});
}

void ClippingPanel::change(std::size_t row, const core::ClipPlane& plane)
{
    core::ClipRegion clip = m_workspace.clip();
    clip.planes[row] = plane;
    m_workspace.viewSteps().change(clip);
}

void ClippingPanel::reset()
{
    m_workspace.viewSteps().change(core::wholeVolume(m_workspace.volume()->geometry));
}

} // namespace ui
