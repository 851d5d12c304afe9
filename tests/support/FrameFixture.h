// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "gpu/edit/VoxelFields.h"
#include "gpu/frame/FrameScheduler.h"
#include "gpu/shaders/ShaderLibrary.h"
#include "gpu/textures/VolumeTextures.h"
#include "tests/reference/DenseFields.h"

#include <QImage>

#include <functional>
#include <memory>
#include <vector>

namespace test {

/// An edit worker that remembers what it was asked to show, and keeps footprints of pieces where it
/// has fields.
class IdleEdits : public gpu::EditWorker {
public:
    bool work() override;
    void showSegments(const std::bitset<256>& labels) override { shown = labels; }
    void showPieces(const std::vector<gpu::PieceSource>& sources) override;
    void showAtTolerance(const std::optional<gpu::ToleranceDisplay>& at) override;
    void warmUp() override { }
    std::bitset<256> shown;
    std::unique_ptr<gpu::VoxelFields> fields;
    std::vector<gpu::PieceSource> pieces;
};

/// Renderers on the test's own thread, without an engine: everything happens in settle(), so that
/// nothing depends on time. Needs a current context.
class FrameFixture {
public:
    explicit FrameFixture(gpu::ShaderLibrary library = gpu::ShaderLibrary::builtIn());

    /// Opens a volume whose code at voxel (i, j, k) is codeAt(world position in LPS mm).
    void open(const core::VolumeGeometry& geometry,
        const std::function<double(const glm::dvec3& lps)>& codeAt,
        const core::VoxelEncoding& encoding = {});
    /// Fills a box of a field; 255 is carved away or inside a segment.
    void fill(gpu::VolumeField field, const core::VoxelBox& box, std::uint8_t value);
    /// Carves a field of coverage, or a box, away as sculpting does: by its radiation.
    void carve(const reference::DenseArray<std::uint8_t>& coverage);
    void carveBox(const core::VoxelBox& box);
    /// Puts coverage and labels in place as an engine would; radiation and pieces follow. Call it
    /// after open().
    void put(const reference::DenseFields& state);

    /// Works until there is nothing left to do. @return frames handed out meanwhile
    std::vector<gpu::Frame> settle();
    /// Requests and settles; the last frame.
    gpu::Frame draw(
        const gpu::Scene& scene, const glm::ivec2& size, const gpu::SegmentDisplay& segments = {});

    gpu::ShaderLibrary shaders;
    gpu::FieldPrograms fieldPrograms;
    gpu::VolumeTextures volume;
    IdleEdits edits;
    gpu::FrameScheduler scheduler;
    int wakeUps = 0;

private:
    std::vector<gpu::Frame> m_frames;
};

/// A box of voxels centred on the origin, axes along LPS.
[[nodiscard]] core::VolumeGeometry centredGeometry(
    const glm::ivec3& size, const glm::dvec3& spacingMm = glm::dvec3(1.0));

[[nodiscard]] glm::ivec3 pixel(const gpu::Frame& frame, int x, int y);
[[nodiscard]] QImage imageOf(const gpu::Frame& frame);

} // namespace test
