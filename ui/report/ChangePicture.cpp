// SPDX-License-Identifier: Apache-2.0
#include "ui/report/ChangePicture.h"

#include "core/brick/VoxelRunSets.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr double marginMm = 30.0;
constexpr double sidePixels = 640.0; ///< of the longer side

/// The voxels of one slice that are in a set.
std::vector<bool> inSlice(const core::VoxelRuns& runs, std::uint64_t first, std::uint64_t count)
{
    std::vector<bool> found(count, false);
    for (const core::VoxelRun& run : runs.runs()) {
        const std::uint64_t begin = std::max(run.first, first);
        const std::uint64_t end = std::min(run.first + run.count, first + count);
        for (std::uint64_t at = begin; at < end; ++at)
            found[std::size_t(at - first)] = true;
    }
    return found;
}

/// The slice with most voxels, the first of several.
std::uint64_t fullestSlice(const core::VoxelRuns& runs, std::uint64_t voxelsPerSlice)
{
    std::vector<std::uint64_t> counts;
    for (const core::VoxelRun& run : runs.runs()) {
        std::uint64_t at = run.first;
        std::uint64_t remaining = run.count;
        while (remaining > 0) {
            const std::uint64_t count = std::min(remaining, voxelsPerSlice - at % voxelsPerSlice);
            const auto slice = std::size_t(at / voxelsPerSlice);
            counts.resize(std::max(counts.size(), slice + 1), 0);
            counts[slice] += count;
            at += count;
            remaining -= count;
        }
    }
    return std::uint64_t(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

/// How a native slice lies on the picture: which of its two index axes runs to the right, and
/// which of them run against the picture's.
struct Turn {
    bool swapped = false;
    bool flippedX = false;
    bool flippedY = false;
};

Turn turnOf(const core::VolumeGeometry& geometry)
{
    const glm::dmat3 axes(geometry.indexToWorld);
    const glm::dvec3 across = glm::abs(axes[2]);
    glm::dvec3 right(1.0, 0.0, 0.0); // the patient's left
    glm::dvec3 down(0.0, 0.0, -1.0); // the feet
    if (across.z >= across.x && across.z >= across.y)
        down = {0.0, 1.0, 0.0}; // axial: the back
    else if (across.x >= across.y)
        right = {0.0, 1.0, 0.0}; // sagittal: the back
    const glm::dvec3 i = glm::normalize(axes[0]);
    const glm::dvec3 j = glm::normalize(axes[1]);
    Turn turn;
    turn.swapped = std::abs(glm::dot(j, right)) > std::abs(glm::dot(i, right));
    turn.flippedX = glm::dot(turn.swapped ? j : i, right) < 0.0;
    turn.flippedY = glm::dot(turn.swapped ? i : j, down) < 0.0;
    return turn;
}

/// The pixels of a slice that are shown, both ends included.
struct Cut {
    glm::ivec2 first{0};
    glm::ivec2 last{0};
};

Cut cutAround(const std::vector<bool>& one, const std::vector<bool>& other, const glm::ivec2& size,
    const glm::dvec2& spacing)
{
    Cut cut{.first = size, .last = glm::ivec2(-1)};
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const std::size_t at = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
            if (one[at] || other[at]) {
                cut.first = glm::min(cut.first, glm::ivec2(x, y));
                cut.last = glm::max(cut.last, glm::ivec2(x, y));
            }
        }
    }
    const glm::ivec2 margin(glm::ceil(glm::dvec2(marginMm) / spacing));
    return {.first = glm::max(cut.first - margin, glm::ivec2(0)),
        .last = glm::min(cut.last + margin, size - 1)};
}

QRgb tinted(int grey, bool now, bool before)
{
    if (!now && !before)
        return qRgb(grey, grey, grey);
    const QColor tint = now && before ? QColor(0x3c, 0x82, 0xdc)
        : now                         ? QColor(0x28, 0xc8, 0x50)
                                      : QColor(0xe6, 0x3c, 0x32);
    const int share = now && before ? 25 : 60; // of 100
    const auto mixed = [&](int colour) { return (grey * (100 - share) + colour * share) / 100; };
    return qRgb(mixed(tint.red()), mixed(tint.green()), mixed(tint.blue()));
}

} // namespace

std::optional<ChangePicture> changePicture(const core::Volume& volume,
    std::span<const std::uint16_t> codes, const core::VoxelRuns& now, const core::VoxelRuns& before)
{
    const core::VoxelRuns changed = core::differing(now, before);
    if (changed.empty())
        return std::nullopt;
    const core::VolumeGeometry& geometry = volume.geometry;
    const glm::ivec2 size(geometry.size.x, geometry.size.y);
    const glm::dvec2 spacing(geometry.spacingMm());
    const std::uint64_t perSlice = std::uint64_t(size.x) * std::uint64_t(size.y);
    const std::uint64_t slice = fullestSlice(changed, perSlice);
    const std::vector<bool> inNow = inSlice(now, slice * perSlice, perSlice);
    const std::vector<bool> inBefore = inSlice(before, slice * perSlice, perSlice);
    const Cut cut = cutAround(inNow, inBefore, size, spacing);

    const core::WindowLevel& window = volume.defaultWindow;
    const glm::ivec2 shown = cut.last - cut.first + 1;
    const Turn turn = turnOf(geometry);
    QImage image(
        turn.swapped ? QSize(shown.y, shown.x) : QSize(shown.x, shown.y), QImage::Format_RGB32);
    for (int y = 0; y < shown.y; ++y) {
        for (int x = 0; x < shown.x; ++x) {
            const std::size_t at =
                std::size_t(cut.first.y + y) * std::size_t(size.x) + std::size_t(cut.first.x + x);
            const double value = volume.encoding.value(codes[std::size_t(slice * perSlice) + at]);
            const double share = (value - window.centre) / std::max(window.width, 1e-9) + 0.5;
            const int lit = int(std::lround(std::clamp(share, 0.0, 1.0) * 255.0));
            const int grey = volume.displayInverted ? 255 - lit : lit;
            QPoint place = turn.swapped ? QPoint(y, x) : QPoint(x, y);
            if (turn.flippedX)
                place.setX(image.width() - 1 - place.x());
            if (turn.flippedY)
                place.setY(image.height() - 1 - place.y());
            image.setPixel(place, tinted(grey, inNow[at], inBefore[at]));
        }
    }
    const glm::dvec2 mm = turn.swapped ? glm::dvec2(spacing.y, spacing.x) : spacing;
    const glm::dvec2 sidesMm(image.width() * mm.x, image.height() * mm.y);
    const double scale = sidePixels / std::max(sidesMm.x, sidesMm.y);
    const QSize pixels(std::max(1, int(std::lround(sidesMm.x * scale))),
        std::max(1, int(std::lround(sidesMm.y * scale))));
    return ChangePicture{.slice = int(slice),
        .image = image.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)};
}

} // namespace ui
