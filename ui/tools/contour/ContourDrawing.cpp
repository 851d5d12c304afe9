// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourDrawing.h"

#include "core/contour/ContourState.h"
#include "core/volume/VolumeGeometry.h"
#include "ui/base/Theme.h"
#include "ui/tools/aim/CursorLabel.h"

#include <QPainter>
#include <QRect>

#include <cmath>
#include <cstdint>
#include <variant>
#include <vector>

namespace ui {

namespace {

/// What a pixel shows.
enum class Seen : std::uint8_t { Nothing, Kept, Gained, Lost };

Seen seenAt(const glm::ivec3& voxel, const core::ContourState& state)
{
    const bool was = state.wasInside(voxel);
    if (state.isInside(voxel))
        return was ? Seen::Kept : Seen::Gained;
    return was ? Seen::Lost : Seen::Nothing;
}

bool isInSegment(Seen seen)
{
    return seen == Seen::Kept || seen == Seen::Gained;
}

/// Where the box of a contour may be seen in a view, with a rim.
QRect areaOf(
    const core::VoxelBox& box, const ViewContext& view, const core::VolumeGeometry& geometry)
{
    constexpr int rim = 2;
    QRectF area;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 index = glm::dvec3(corner & 1 ? box.maximum.x : box.minimum.x,
                                     corner & 2 ? box.maximum.y : box.minimum.y,
                                     corner & 4 ? box.maximum.z : box.minimum.z)
            - 0.5;
        const QPointF pixel = view.toPixel(geometry.toWorld(index));
        area = corner == 0 ? QRectF(pixel, QSizeF(1e-6, 1e-6))
                           : area.united(QRectF(pixel, QSizeF(1e-6, 1e-6)));
    }
    // A view that is zoomed far in would have numbers that no int holds.
    return area.adjusted(-rim, -rim, rim, rim)
        .intersected(QRectF(QPointF(0.0, 0.0), view.sizePixels))
        .toAlignedRect();
}

/// What of a slice decides where voxels are seen.
bool showsSamePixels(const ViewContext& one, const ViewContext& other)
{
    const auto* its = std::get_if<gpu::SliceScene>(&one.scene);
    const auto* others = std::get_if<gpu::SliceScene>(&other.scene);
    return its && others && one.sizePixels == other.sizePixels
        && its->centreLps == others->centreLps && its->rightLps == others->rightLps
        && its->downLps == others->downLps && its->mmPerPixel == others->mmPerPixel;
}

QRgb contourTint(const QColor& colour, double opacity)
{
    QColor tint = colour;
    tint.setAlphaF(opacity);
    return qPremultiply(tint.rgba());
}

} // namespace

QImage ContourDrawing::picture(const QRect& area, double ratio, const ViewContext& view,
    const core::ContourState& state, const core::VolumeGeometry& geometry, const QColor& segment)
{
    const int width = int(std::lround(area.width() * ratio));
    const int height = int(std::lround(area.height() * ratio));
    const auto indexAt = [&](double x, double y) {
        return geometry.toIndex(
            view.toLps(QPointF(area.left() + x / ratio, area.top() + y / ratio)));
    };
    const glm::dvec3 first = indexAt(0.5, 0.5) + 0.5;
    const glm::dvec3 right = indexAt(1.5, 0.5) + 0.5 - first;
    const glm::dvec3 down = indexAt(0.5, 1.5) + 0.5 - first;
    std::vector<Seen> seen;
    seen.reserve(std::size_t(width) * std::size_t(height));
    bool isAnything = false;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            seen.push_back(seenAt(
                glm::ivec3(glm::floor(first + double(x) * right + double(y) * down)), state));
            isAnything = isAnything || seen.back() != Seen::Nothing;
        }
    }
    if (!isAnything)
        return {};
    const QRgb outline = contourTint(toolColour(), 1.0);
    const QRgb colours[] = {
        0, contourTint(segment, 0.2), contourTint(segment, 0.45), contourTint(theme::bad, 0.4)};
    QImage image(width, height, QImage::Format_ARGB32_Premultiplied);
    const auto at = [&](int x, int y) {
        return seen[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    };
    for (int y = 0; y < height; ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < width; ++x) {
            const Seen own = at(x, y);
            const bool atRim = isInSegment(own)
                && ((x > 0 && !isInSegment(at(x - 1, y)))
                    || (x + 1 < width && !isInSegment(at(x + 1, y)))
                    || (y > 0 && !isInSegment(at(x, y - 1)))
                    || (y + 1 < height && !isInSegment(at(x, y + 1))));
            row[x] = atRim ? outline : colours[std::size_t(own)];
        }
    }
    image.setDevicePixelRatio(ratio);
    return image;
}

void ContourDrawing::paint(QPainter& painter, const ViewContext& view, const State& state,
    const core::VolumeGeometry& geometry, const QColor& segment)
{
    const double ratio = painter.device()->devicePixelRatioF();
    Drawn& its = m_drawn[view.view];
    const bool isInPlace =
        its.wish && its.wish->ratio == ratio && showsSamePixels(its.wish->view, view);
    if (isInPlace && !its.image.isNull())
        painter.drawImage(its.corner, its.image);
    const bool isRight =
        isInPlace && its.wish->segment == segment && its.wish->state.lock() == state;
    if (isRight || its.making.running())
        return;
    const QRect area = areaOf(state->box(), view, geometry);
    const Wish wish{.view = view, .ratio = ratio, .segment = segment, .state = state};
    if (area.isEmpty()) {
        its.wish = wish;
        its.image = QImage();
        return;
    }
    its.making = m_background.start(
        this,
        [area, ratio, view, state, geometry, segment] {
            return picture(area, ratio, view, *state, geometry, segment);
        },
        [this, wish, corner = area.topLeft()](const core::Result<QImage>& image) {
            Drawn& made = m_drawn[wish.view.view];
            made.wish = wish;
            made.corner = corner;
            // Where there is no room for it, it is not shown, and not asked for again and again.
            made.image = image ? *image : QImage();
            Q_EMIT drawn();
        });
}

} // namespace ui
