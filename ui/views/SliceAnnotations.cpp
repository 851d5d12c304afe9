// SPDX-License-Identifier: Apache-2.0
// What is drawn over the picture of a slice.
#include "gpu/scene/WindowMapping.h"
#include "ui/base/NumberText.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/base/TimeText.h"
#include "ui/geometry/OrientationLetters.h"
#include "ui/overlays/Annotations.h"
#include "ui/overlays/ClipOutline.h"
#include "ui/overlays/ColourBar.h"
#include "ui/overlays/MeasurementLines.h"
#include "ui/overlays/PlaneOutline.h"
#include "ui/overlays/ReferenceLines.h"
#include "ui/views/SliceView.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/InitialDisplay.h"
#include "ui/workspace/Refinement.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ui {

namespace {

/// The standard plane that lies across a direction, in its colour.
QColor colourAcross(const glm::dvec3& directionLps)
{
    const glm::dvec3 along = glm::abs(directionLps);
    return along.z > along.x && along.z > along.y ? theme::axial
        : along.x > along.y                       ? theme::sagittal
                                                  : theme::coronal;
}

/// Mode and thickness of a slab, and what tools work on; empty if there is none.
QString slabText(const gpu::SceneSlab& slab)
{
    const QString thickness = QObject::tr("%1 mm slab · tools work on the middle slice")
                                  .arg((2 * slab.reach + 1) * slab.stepMm, 0, 'f', 1);
    switch (slab.mode) {
    case gpu::SlabMode::Maximum:
        return QStringLiteral("MIP ") + thickness;
    case gpu::SlabMode::Minimum:
        return QStringLiteral("MinIP ") + thickness;
    case gpu::SlabMode::Mean:
        return QStringLiteral("mean ") + thickness;
    case gpu::SlabMode::Off:
        break;
    }
    return {};
}

} // namespace

bool SliceView::isPatientPlane() const
{
    return m_axes.normalLps == sliceAxes(*m_orientation).normalLps;
}

QPointF SliceView::directionOf(SliceOrientation plane, const ViewContext& view) const
{
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const glm::dvec3 along = glm::cross(m_axes.normalLps, m_planes->axes(plane).normalLps);
    const double length = glm::length(along);
    if (length < 1e-6)
        return {1.0, 0.0}; // they are one plane, which no turn makes them
    return {glm::dot(along, slice.rightLps) / length, glm::dot(along, slice.downLps) / length};
}

void SliceView::paintHandles(QPainter& painter, const ViewContext& shown) const
{
    for (const Handle& each : handles(shown)) {
        painter.setPen(QPen(QColor(0, 0, 0, 160), 3.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(each.at, 5.0, 5.0);
        painter.setPen(QPen(sliceColour(each.plane), 1.4));
        painter.drawEllipse(each.at, 5.0, 5.0);
    }
}

QString SliceView::windowText() const
{
    const core::Volume& volume = *shownVolume();
    const core::WindowLevel window = windowLevel();
    const double span = volume.maximum - volume.minimum;
    QString text = QStringLiteral("W %1  L %2")
                       .arg(valueText(window.width, QString(), span),
                           valueText(window.centre, volume.unit, span));
    for (const WindowPreset& preset : windowPresets(volume)) {
        if (preset.window == window)
            return text + QStringLiteral(" · ") + preset.name;
    }
    return text;
}

void SliceView::paintColours(QPainter& painter, const gpu::SliceScene& slice) const
{
    if (slice.colours == gpu::ColourMap::Grey)
        return;
    const core::Volume& volume = *shownVolume();
    // As the picture is drawn.
    const gpu::GreyRamp ramp = gpu::greyRampOf(volume.encoding, slice.window);
    const double half = 0.5 * ramp.span;
    const auto end = [&](double value) {
        return valueText(value, volume.unit, volume.maximum - volume.minimum);
    };
    paintColourBar(painter, textRect(),
        {.map = slice.colours,
            .inverted = slice.inverted,
            .upper = end(ramp.middle + half),
            .lower = end(ramp.middle - half)});
}

void SliceView::paintCross(QPainter& painter, const ViewContext& shown)
{
    if (m_planes && !m_planes->alongPatient()) {
        for (const SliceOrientation each : MprPlanes::all) {
            if (each != m_orientation)
                paintCrosshairLine(painter, rect(), shown.toPixel(throughLps()),
                    directionOf(each, shown), sliceColour(each));
        }
        return;
    }
    // Each line is another standard plane, seen from its edge: it lies across the other line.
    const auto& slice = std::get<gpu::SliceScene>(shown.scene);
    paintCrosshair(painter, rect(), shown.toPixel(throughLps()), colourAcross(slice.downLps),
        colourAcross(slice.rightLps));
}

void SliceView::paintOtherSlices(QPainter& painter, const ViewContext& shown) const
{
    std::vector<ReferencePlane> planes;
    for (const SliceOrientation each :
        {SliceOrientation::Axial, SliceOrientation::Sagittal, SliceOrientation::Coronal})
        planes.push_back({.pointLps = workspace().crosshairLps(),
            .normalLps =
                (m_referencePlanes ? m_referencePlanes->axes(each) : sliceAxes(each)).normalLps,
            .colour = sliceColour(each)});
    paintReferenceLines(
        painter, shown, planes, shownVolume()->geometry, shown.toPixel(workspace().crosshairLps()));
}

CornerTexts SliceView::cornerTexts(const gpu::SliceScene& slice) const
{
    const core::Volume& volume = *shownVolume();
    const double position = glm::dot(slice.centreLps, m_axes.normalLps);
    const glm::dvec3 side = position < 0.0 ? -m_axes.normalLps : m_axes.normalLps;
    const int number = m_stack.numberAt(slice.centreLps);
    // Screen pixels per voxel of the volume.
    const glm::dvec3 spacing = volume.geometry.spacingMm();
    const double zoom = std::min({spacing.x, spacing.y, spacing.z}) / slice.mmPerPixel;

    CornerTexts texts;
    texts.title = title();
    texts.titleColour = barColour();
    if (workspace().viewOptions().showPatient)
        texts.topLeft = patientLines(volume.identity);
    texts.topRight = {studyText(volume.identity), seriesText(volume.identity), timeText(volume)};
    texts.bottomLeft = {QObject::tr("zoom %1").arg(zoom, 0, 'f', 1), windowText()};
    if (slice.slab.mode != gpu::SlabMode::Off)
        texts.bottomLeft.append(slabText(slice.slab));
    if (const QString caution = workspace().refinement().caution(); !early() && !caution.isEmpty())
        texts.bottomLeft.append(caution);
    if (m_planes && !isPatientPlane())
        texts.bottomLeft.append(tr("oblique"));
    if (m_turn.mirrored)
        texts.bottomLeft.append(tr("mirrored"));
    texts.bottomRight = {QObject::tr("%1 / %2 · %3 %4 mm")
                             .arg(number + 1)
                             .arg(m_stack.count)
                             .arg(directionLetters(side), numberText(std::abs(position), 1))};
    return texts;
}

void SliceView::paintAnnotations(QPainter& painter, const ViewContext& shown)
{
    const core::Volume& volume = *shownVolume();
    const Workspace::ViewOptions& options = workspace().viewOptions();
    const auto& slice = std::get<gpu::SliceScene>(shown.scene);
    const CornerTexts texts = cornerTexts(slice);

    if (!early()) {
        paintClipSection(painter, shown, workspace().clip(), volume.geometry);
        if (const auto box = growBoxOf(workspace().growSettings(), volume.geometry))
            paintBoxSection(painter, shown, *box, volume.geometry, theme::good);
        paintMeasurements(painter, shown, workspace());
    }
    // Lines pass behind texts, which they would cross out.
    painter.save();
    painter.setClipRegion(QRegion(rect()) - cornersRegion(textRect(), texts)
        - edgeLettersRegion(textRect(), slice.rightLps, slice.downLps));
    if (!early())
        paintPlaneLine(painter, shown, workspace().plane());
    if (options.referenceLines && !early())
        paintOtherSlices(painter, shown);
    if (options.showCrosshair)
        paintCross(painter, shown);
    painter.restore();
    if (penOverPicture() && !early())
        paintHandles(painter, shown);
    paintEdgeLetters(painter, textRect(), slice.rightLps, slice.downLps);
    paintColours(painter, slice);
    paintCorners(painter, textRect(), texts);
    paintScaleBar(painter, rect(), height() - 34, slice.mmPerPixel);
    if (m_box) {
        for (const QPen& pen :
            {QPen(QColor(0, 0, 0, 140), 3.0), QPen(theme::accent, 1.0, Qt::DashLine)}) {
            painter.setPen(pen);
            painter.drawRect(m_box->normalized());
        }
    }
}

} // namespace ui
