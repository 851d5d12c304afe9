// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourGhost.h"

#include "core/contour/ContourState.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ui {

namespace {

/// What of a view decides where things are seen.
bool seesAlike(const ViewContext& one, const ViewContext& other)
{
    const auto* its = std::get_if<gpu::VolumeScene>(&one.scene);
    const auto* others = std::get_if<gpu::VolumeScene>(&other.scene);
    return its && others && one.sizePixels == other.sizePixels && its->eyeLps == others->eyeLps
        && its->targetLps == others->targetLps && its->up == others->up
        && its->heightMm == others->heightMm && its->orthographic == others->orthographic;
}

/// The voxels of a state by their place in its box.
class BodyVoxels {
public:
    BodyVoxels(const core::ContourState& state, const core::VolumeGeometry& geometry)
        : m_voxels(state.voxels())
        , m_axes(geometry.indexToWorld)
        , m_extent(state.box().maximum - state.box().minimum)
    {
    }
    [[nodiscard]] const glm::ivec3& extent() const { return m_extent; }
    /// What lies beside the box is not inside.
    [[nodiscard]] bool has(int x, int y, int z) const
    {
        if (x < 0 || y < 0 || z < 0 || x >= m_extent.x || y >= m_extent.y || z >= m_extent.z)
            return false;
        return core::ContourState::isInside(
            m_voxels[(std::size_t(z) * std::size_t(m_extent.y) + std::size_t(y))
                    * std::size_t(m_extent.x)
                + std::size_t(x)]);
    }
    [[nodiscard]] bool isAtSurface(int x, int y, int z) const
    {
        return has(x, y, z)
            && !(has(x - 1, y, z) && has(x + 1, y, z) && has(x, y - 1, z) && has(x, y + 1, z)
                && has(x, y, z - 1) && has(x, y, z + 1));
    }
    /// Towards what is not inside around a voxel; of no length in a speck.
    [[nodiscard]] glm::dvec3 outwardsLps(int x, int y, int z) const
    {
        constexpr int reach = 2;
        glm::dvec3 sum(0.0);
        for (int dz = -reach; dz <= reach; ++dz) {
            for (int dy = -reach; dy <= reach; ++dy) {
                for (int dx = -reach; dx <= reach; ++dx) {
                    if (!has(x + dx, y + dy, z + dz))
                        sum += m_axes * glm::dvec3(dx, dy, dz);
                }
            }
        }
        const double length = glm::length(sum);
        return length > 1e-9 ? sum / length : glm::dvec3(0.0);
    }

private:
    const std::vector<std::uint8_t>& m_voxels;
    glm::dmat3 m_axes;
    glm::ivec3 m_extent;
};

/// Voxels as rectangles on the screen, the nearest ones in front.
class GhostCanvas {
public:
    GhostCanvas(const ViewContext& view, const core::VolumeGeometry& geometry, const QColor& colour)
        : m_view(view)
        , m_scene(std::get<gpu::VolumeScene>(view.scene))
        , m_forward(glm::normalize(m_scene.targetLps - m_scene.eyeLps))
        , m_right(glm::normalize(glm::cross(m_forward, m_scene.up)))
        , m_down(glm::cross(m_forward, m_right))
        , m_targetDepth(glm::dot(m_scene.targetLps - m_scene.eyeLps, m_forward))
        , m_colour(colour)
        , m_image(std::max(int(std::lround(view.sizePixels.width())), 1),
              std::max(int(std::lround(view.sizePixels.height())), 1),
              QImage::Format_ARGB32_Premultiplied)
        , m_depths(std::size_t(m_image.width()) * std::size_t(m_image.height()),
              std::numeric_limits<float>::infinity())
    {
        m_image.fill(Qt::transparent);
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3 step(geometry.indexToWorld[axis]);
            m_halfMm.x += 0.5 * std::abs(glm::dot(step, m_right));
            m_halfMm.y += 0.5 * std::abs(glm::dot(step, m_down));
        }
    }
    /// @param outwards the direction of its surface
    void add(const glm::dvec3& lps, const glm::dvec3& outwards)
    {
        const double depth = glm::dot(lps - m_scene.eyeLps, m_forward);
        const double nearer = m_scene.orthographic ? 1.0 : m_targetDepth / depth;
        if (!m_scene.orthographic && depth < 1e-3)
            return; // beside or behind the eye
        const QPointF middle = m_view.toPixel(m_scene.eyeLps + m_forward * m_targetDepth
            + (lps - m_scene.eyeLps - m_forward * depth) * nearer);
        const glm::dvec2 half = m_halfMm * nearer / m_view.mmPerPixel();
        // The pixels whose middles it covers.
        const int left = first(middle.x() - half.x, m_image.width());
        const int right = first(middle.x() + half.x, m_image.width());
        const int top = first(middle.y() - half.y, m_image.height());
        const int bottom = first(middle.y() + half.y, m_image.height());
        const QRgb pixel = shaded(-glm::dot(outwards, m_forward));
        for (int y = top; y < bottom; ++y) {
            auto* row = reinterpret_cast<QRgb*>(m_image.scanLine(y));
            for (int x = left; x < right; ++x) {
                float& known =
                    m_depths[std::size_t(y) * std::size_t(m_image.width()) + std::size_t(x)];
                if (float(depth) >= known)
                    continue;
                known = float(depth);
                row[x] = pixel;
            }
        }
    }
    [[nodiscard]] const QImage& image() const { return m_image; }

private:
    /// The first pixel whose middle is not before an edge.
    [[nodiscard]] static int first(double edge, int most)
    {
        return int(std::clamp(std::ceil(edge - 0.5), 0.0, double(most)));
    }
    [[nodiscard]] QRgb shaded(double towardsViewer) const
    {
        constexpr double opacity = 0.7;
        constexpr double least = 0.3;
        const double light = least + (1.0 - least) * std::clamp(towardsViewer, 0.0, 1.0);
        const auto part = [light](int channel) { return int(std::lround(light * channel)); };
        return qPremultiply(qRgba(part(m_colour.red()), part(m_colour.green()),
            part(m_colour.blue()), int(std::lround(opacity * 255.0))));
    }

    const ViewContext& m_view;
    const gpu::VolumeScene& m_scene;
    glm::dvec3 m_forward;
    glm::dvec3 m_right;
    glm::dvec3 m_down;
    double m_targetDepth;
    QColor m_colour;
    glm::dvec2 m_halfMm{0.0}; ///< of a voxel, across and down
    QImage m_image;
    std::vector<float> m_depths;
};

} // namespace

QImage ContourGhost::picture(const ViewContext& view, const core::ContourState& state,
    const core::VolumeGeometry& geometry, const QColor& segment)
{
    const BodyVoxels voxels(state, geometry);
    GhostCanvas canvas(view, geometry, segment);
    for (int z = 0; z < voxels.extent().z; ++z) {
        for (int y = 0; y < voxels.extent().y; ++y) {
            for (int x = 0; x < voxels.extent().x; ++x) {
                if (voxels.isAtSurface(x, y, z))
                    canvas.add(
                        geometry.toWorld(glm::dvec3(state.box().minimum) + glm::dvec3(x, y, z)),
                        voxels.outwardsLps(x, y, z));
            }
        }
    }
    return canvas.image();
}

void ContourGhost::paint(QPainter& painter, const ViewContext& view, const State& state,
    const core::VolumeGeometry& geometry, const QColor& segment)
{
    if (state->voxelCount() > mostVoxels)
        return;
    const Drawn& known = m_drawn[view.view];
    const bool isHere = !known.image.isNull() && seesAlike(known.view, view);
    if (isHere)
        painter.drawImage(QPoint(0, 0), known.image);
    if ((isHere && known.state.lock() == state && known.segment == segment) || m_background.busy())
        return;
    m_background.start(
        this, [state, geometry, view, segment] { return picture(view, *state, geometry, segment); },
        [this, view, segment, of = std::weak_ptr(state)](const core::Result<QImage>& image) {
            // Where there is no room for it, it is not shown, and not asked for again and again.
            m_drawn[view.view] = {.state = of,
                .view = view,
                .segment = segment,
                .image = image ? *image : QImage(1, 1, QImage::Format_ARGB32_Premultiplied)};
            if (!image)
                m_drawn[view.view].image.fill(Qt::transparent);
            Q_EMIT drawn();
        });
}

} // namespace ui
