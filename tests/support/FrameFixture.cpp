// SPDX-License-Identifier: Apache-2.0
#include "tests/support/FrameFixture.h"

#include "gpu/edit/BrickImages.h"
#include "tests/reference/Radiation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace test {

bool IdleEdits::work()
{
    if (fields && fields->barriersStale())
        fields->updateBarriers();
    const bool stale = fields && fields->piecesStale();
    if (stale)
        fields->updatePieces(7);
    return stale;
}

void IdleEdits::showAtTolerance(const std::optional<gpu::ToleranceDisplay>& at)
{
    if (fields)
        fields->showAtTolerance(at);
}

void IdleEdits::showPieces(const std::vector<gpu::PieceSource>& sources)
{
    pieces = sources;
    if (fields)
        fields->setPieces(sources);
}

FrameFixture::FrameFixture(gpu::ShaderLibrary library)
    : shaders(std::move(library))
    , fieldPrograms(shaders)
    , scheduler(
          {.volume = volume, .edits = edits, .shaders = shaders, .wake = [this] { ++wakeUps; }})
{
    scheduler.setListener([this](const gpu::Frame& frame) { m_frames.push_back(frame); });
}

void FrameFixture::open(const core::VolumeGeometry& geometry,
    const std::function<double(const glm::dvec3&)>& codeAt, const core::VoxelEncoding& encoding)
{
    std::vector<std::uint16_t> codes;
    codes.reserve(geometry.voxelCount());
    for (int k = 0; k < geometry.size.z; ++k)
        for (int j = 0; j < geometry.size.y; ++j)
            for (int i = 0; i < geometry.size.x; ++i) {
                const double code = codeAt(geometry.toWorld(glm::dvec3(i, j, k)));
                codes.push_back(std::uint16_t(std::lround(std::clamp(code, 0.0, 65535.0))));
            }
    edits.fields.reset();
    if (!volume.open(geometry.size, codes))
        qFatal("the test volume cannot be opened");
    volume.setGeometry(geometry, encoding);
}

void FrameFixture::fill(gpu::VolumeField field, const core::VoxelBox& box, std::uint8_t value)
{
    gpu::Texture3D* textures[] = {&volume.labels(), &volume.radiation(), &volume.segmentation()};
    textures[int(field)]->clear(box.minimum, box.maximum - box.minimum, &value);
    volume.markDirty(field, box);
}

void FrameFixture::carve(const reference::DenseArray<std::uint8_t>& coverage)
{
    volume.radiation().upload<std::uint8_t>(reference::radiation(coverage).values);
    volume.markDirty(gpu::VolumeField::Radiation, {glm::ivec3(0), coverage.size});
}

void FrameFixture::carveBox(const core::VoxelBox& box)
{
    reference::DenseArray<std::uint8_t> coverage{volume.size(), {}};
    coverage.values.resize(
        std::size_t(volume.size().x) * std::size_t(volume.size().y) * std::size_t(volume.size().z));
    for (int z = box.minimum.z; z < box.maximum.z; ++z)
        for (int y = box.minimum.y; y < box.maximum.y; ++y)
            for (int x = box.minimum.x; x < box.maximum.x; ++x)
                coverage.at({x, y, z}) = 255;
    carve(coverage);
}

void FrameFixture::put(const reference::DenseFields& state)
{
    if (!edits.fields) {
        edits.fields = std::make_unique<gpu::VoxelFields>(fieldPrograms, volume);
        edits.fields->setPieces(edits.pieces);
    }
    std::vector<core::BrickImage> images;
    for (const core::BrickKey& key : state.occupiedBricks())
        images.push_back({.key = key, .bytes = state.readBrick(key)});
    static_cast<void>(gpu::swapImages(*edits.fields, std::move(images)));
}

std::vector<gpu::Frame> FrameFixture::settle()
{
    for (bool busy = true; busy;) {
        busy = edits.work();
        busy = scheduler.work(false) || busy;
    }
    return std::exchange(m_frames, {});
}

gpu::Frame FrameFixture::draw(
    const gpu::Scene& scene, const glm::ivec2& size, const gpu::SegmentDisplay& segments)
{
    gpu::FrameRequest request;
    request.view = 99;
    request.sizePixels = size;
    request.scene = scene;
    request.segments = segments;
    scheduler.request(request);
    const std::vector<gpu::Frame> frames = settle();
    scheduler.forget(99);
    if (frames.empty())
        qFatal("no frame came");
    return frames.back();
}

core::VolumeGeometry centredGeometry(const glm::ivec3& size, const glm::dvec3& spacingMm)
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    for (int axis = 0; axis < 3; ++axis) {
        geometry.indexToWorld[axis][axis] = spacingMm[axis];
        geometry.indexToWorld[3][axis] = -0.5 * (size[axis] - 1) * spacingMm[axis];
    }
    return geometry;
}

glm::ivec3 pixel(const gpu::Frame& frame, int x, int y)
{
    const std::uint8_t* bytes = &(*frame.rgba)[std::size_t(y * frame.sizePixels.x + x) * 4];
    return {bytes[0], bytes[1], bytes[2]};
}

QImage imageOf(const gpu::Frame& frame)
{
    return QImage(
        frame.rgba->data(), frame.sizePixels.x, frame.sizePixels.y, QImage::Format_RGBA8888)
        .copy();
}

} // namespace test
