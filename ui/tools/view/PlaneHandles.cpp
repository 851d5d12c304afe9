// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/PlaneHandles.h"

#include "ui/overlays/PlaneOutline.h"
#include "ui/workspace/CuttingPlane.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ui {

namespace {

constexpr double leastPlanePixelsPerMm = 0.25; // of what the view shows of a millimetre across
constexpr double leastPixelsPerRadian = 12.0;
constexpr double small = 1e-3; // radians

double lengthOf(const QPointF& way)
{
    return std::hypot(way.x(), way.y());
}

std::optional<PlaneHandle> turning(const ViewContext& view, const CuttingPlane& plane, int id,
    const glm::dvec3& placeLps, const glm::dvec3& axisLps)
{
    const glm::dvec3 way = glm::cross(axisLps, placeLps - plane.pose().centreLps);
    const QPointF pixel = view.toPixel(placeLps);
    const PlaneHandle handle{.id = id,
        .turns = true,
        .axisLps = axisLps,
        .pixel = pixel,
        .pixelsPerUnit = (view.toPixel(placeLps + small * way) - pixel) / small};
    if (lengthOf(handle.pixelsPerUnit) < leastPixelsPerRadian)
        return std::nullopt;
    return handle;
}

/// @param wayLps that the place goes when the plane moves a millimetre along its normal
std::optional<PlaneHandle> moving(const ViewContext& view, const CuttingPlane& plane,
    const glm::dvec3& placeLps, const glm::dvec3& wayLps)
{
    const QPointF pixel = view.toPixel(placeLps);
    const PlaneHandle handle{.id = 0,
        .turns = false,
        .axisLps = plane.pose().normalLps(),
        .pixel = pixel,
        .pixelsPerUnit = view.toPixel(placeLps + wayLps) - pixel};
    if (lengthOf(handle.pixelsPerUnit) < leastPlanePixelsPerMm / view.mmPerPixel())
        return std::nullopt;
    return handle;
}

void add(std::vector<PlaneHandle>& handles, const std::optional<PlaneHandle>& handle)
{
    if (handle)
        handles.push_back(*handle);
}

std::vector<PlaneHandle> onSlice(const ViewContext& view, const CuttingPlane& plane)
{
    std::vector<PlaneHandle> handles;
    const auto line = planeLine(view, plane);
    if (!line)
        return handles;
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const glm::dvec3 across = glm::cross(slice.rightLps, slice.downLps);
    const glm::dvec3 normal = plane.pose().normalLps();
    // The line goes farther than the plane where this passes through the slice aslant.
    const glm::dvec3 within = normal - glm::dot(normal, across) * across;
    const glm::dvec3 way = line->second - line->first;
    add(handles, moving(view, plane, line->first + 0.5 * way, within / glm::dot(within, within)));
    for (const auto& [id, along] : {std::pair(1, 0.15), std::pair(2, 0.85)}) {
        std::optional<PlaneHandle> handle =
            turning(view, plane, id, line->first + along * way, across);
        if (handle)
            handle->pivot = view.toPixel(plane.pose().centreLps);
        add(handles, handle);
    }
    return handles;
}

std::vector<PlaneHandle> inSpace(const ViewContext& view, const CuttingPlane& plane)
{
    std::vector<PlaneHandle> handles;
    const std::optional<gpu::ScenePlane> shown = plane.scene();
    if (!shown)
        return handles;
    const glm::dvec3 right = shown->halfSizeMm.x * shown->rightLps;
    const glm::dvec3 down = shown->halfSizeMm.y * shown->downLps;
    add(handles, moving(view, plane, shown->centreLps, plane.pose().normalLps()));
    add(handles, turning(view, plane, 1, shown->centreLps - right, shown->downLps));
    add(handles, turning(view, plane, 2, shown->centreLps + right, shown->downLps));
    add(handles, turning(view, plane, 3, shown->centreLps - down, shown->rightLps));
    add(handles, turning(view, plane, 4, shown->centreLps + down, shown->rightLps));
    return handles;
}

} // namespace

std::vector<PlaneHandle> planeHandles(const ViewContext& view, const CuttingPlane& plane)
{
    if (!plane.look().shown)
        return {};
    return view.isSlice() ? onSlice(view, plane) : inSpace(view, plane);
}

bool showsPlaneItself(const ViewContext& view, const CuttingPlane& plane)
{
    const auto* slice = std::get_if<gpu::SliceScene>(&view.scene);
    if (!slice)
        return false;
    const glm::dvec3 normal = plane.pose().normalLps();
    // A view that is mirrored shows it from behind.
    return std::abs(glm::dot(glm::cross(slice->rightLps, slice->downLps), normal)) > 0.9999
        && std::abs(glm::dot(slice->centreLps - plane.pose().centreLps, normal)) < 1e-3;
}

double turnAround(const QPointF& pivot, const QPointF& fromPixel, const QPointF& toPixel)
{
    const QPointF before = fromPixel - pivot;
    const QPointF now = toPixel - pivot;
    return std::atan2(
        before.x() * now.y() - before.y() * now.x(), QPointF::dotProduct(before, now));
}

void dragPlane(CuttingPlane& plane, const PlaneHandle& handle, const QPointF& fromPixel,
    const QPointF& toPixel)
{
    // Slices are looked at along their normal: clockwise is by the right hand.
    if (handle.pivot)
        return plane.turn(
            handle.axisLps, glm::degrees(turnAround(*handle.pivot, fromPixel, toPixel)));
    const double units = QPointF::dotProduct(toPixel - fromPixel, handle.pixelsPerUnit)
        / std::max(QPointF::dotProduct(handle.pixelsPerUnit, handle.pixelsPerUnit), 1e-9);
    if (handle.turns)
        plane.turn(handle.axisLps, glm::degrees(units));
    else
        plane.move(units);
}

} // namespace ui
