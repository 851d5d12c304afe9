// SPDX-License-Identifier: Apache-2.0
#include "ui/views/EarlyPicture.h"

#include "gpu/scene/WindowMapping.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ui {

namespace {

/// Of a slice's thickness: what else would shine through from the next one.
constexpr double mostOutOfPlane = 0.02;

/// The slice's codes, on from its borders as a texture clamps.
class CodeSampler {
public:
    explicit CodeSampler(const core::EarlySlice& early)
        : m_codes(early.codes)
        , m_size(early.volume.geometry.size)
    {
    }
    [[nodiscard]] bool isInside(const glm::dvec2& at) const
    {
        return at.x >= -0.5 && at.y >= -0.5 && at.x < m_size.x - 0.5 && at.y < m_size.y - 0.5;
    }
    /// The value of the voxel there. @pre isInside()
    [[nodiscard]] double nearest(const glm::dvec2& index) const
    {
        const glm::ivec2 pixel(glm::floor(index + 0.5));
        return code(pixel.x, pixel.y);
    }
    /// @pre isInside()
    [[nodiscard]] double linear(const glm::dvec2& index) const
    {
        const glm::dvec2 low = glm::floor(index);
        const glm::dvec2 share = index - low;
        const auto row = [&](int y) {
            const int x = int(low.x);
            return (1.0 - share.x) * code(x, y) + share.x * code(x + 1, y);
        };
        return (1.0 - share.y) * row(int(low.y)) + share.y * row(int(low.y) + 1);
    }

private:
    [[nodiscard]] double code(int x, int y) const
    {
        const auto column = std::size_t(std::clamp(x, 0, m_size.x - 1));
        return m_codes[std::size_t(std::clamp(y, 0, m_size.y - 1)) * std::size_t(m_size.x)
            + column];
    }

    const std::vector<std::uint16_t>& m_codes;
    glm::ivec3 m_size;
};

} // namespace

bool showsEarlySlice(const core::EarlySlice& early, const gpu::SliceScene& scene)
{
    const core::VolumeGeometry& geometry = early.volume.geometry;
    const glm::dmat4 worldToIndex = geometry.worldToIndex();
    const glm::dmat3 directions(worldToIndex);
    const double off = std::abs(geometry.toIndex(scene.centreLps).z - early.slice);
    // How far the plane leaves the slice from one end of the volume to the other.
    double reachMm = 0.0;
    for (const glm::dvec3& corner : geometry.cornersLps())
        reachMm = std::max(reachMm, glm::length(corner - scene.centreLps));
    const double tilt = std::max(
        std::abs((directions * scene.rightLps).z), std::abs((directions * scene.downLps).z));
    return off + tilt * reachMm <= mostOutOfPlane;
}

QImage earlyPicture(
    const core::EarlySlice& early, const gpu::SliceScene& scene, const QSize& pixels)
{
    if (pixels.isEmpty() || !showsEarlySlice(early, scene))
        return {};
    const core::VolumeGeometry& geometry = early.volume.geometry;
    const glm::dmat3 directions(geometry.worldToIndex());
    const glm::dvec2 perX(directions * (scene.rightLps * scene.mmPerPixel));
    const glm::dvec2 perY(directions * (scene.downLps * scene.mmPerPixel));
    const glm::dvec2 base = glm::dvec2(geometry.toIndex(scene.centreLps))
        - perX * (0.5 * pixels.width()) - perY * (0.5 * pixels.height());
    const glm::dvec2 window = gpu::greyOfTexel(early.volume.encoding, scene.window);
    const CodeSampler codes(early);
    const auto codeAt = scene.interpolation == gpu::Interpolation::Nearest ? &CodeSampler::nearest
                                                                           : &CodeSampler::linear;
    QImage picture(pixels, QImage::Format_Grayscale8);
    for (int y = 0; y < pixels.height(); ++y) {
        uchar* line = picture.scanLine(y);
        for (int x = 0; x < pixels.width(); ++x) {
            const glm::dvec2 index = base + perX * (x + 0.5) + perY * (y + 0.5);
            double grey = 0.0;
            if (codes.isInside(index)) {
                grey = std::clamp((codes.*codeAt)(index) / 65535.0 * window.x + window.y, 0.0, 1.0);
                grey = scene.inverted ? 1.0 - grey : grey;
            }
            line[x] = uchar(std::lround(255.0 * grey));
        }
    }
    return picture;
}

} // namespace ui
