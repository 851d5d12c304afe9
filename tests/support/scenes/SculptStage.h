// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/EditSession.h"
#include "gpu/engine/GpuEngine.h"

#include <QImage>

#include <functional>
#include <memory>
#include <vector>

namespace test {

/// A study on the real engine, for tests that sculpt and draw.
class SculptStage {
public:
    explicit SculptStage(core::LoadedVolume study);

    [[nodiscard]] bool isReady() const { return bool(m_session); }
    [[nodiscard]] const core::LoadedVolume& study() const { return m_study; }
    [[nodiscard]] core::EditSession& session() { return *m_session; }
    /// Applies an edit and waits.
    /// @return empty, or the error
    [[nodiscard]] QString apply(const core::Edit& edit);
    /// The coverage of a sculpt layer, or a label plane; x fastest.
    [[nodiscard]] std::vector<std::uint8_t> voxels(core::Field field, std::uint8_t plane);
    /// The index of a voxel in such a list.
    [[nodiscard]] std::size_t placeOf(const glm::ivec3& voxel) const;
    /// The voxels that are seen in the 3D view along a path in the view plane, as a seed stroke
    /// finds them, each once.
    [[nodiscard]] std::vector<glm::ivec3> seenVoxels(
        const gpu::VolumeScene& scene, const std::vector<glm::dvec2>& pathMm);
    /// The time that the first picture of full resolution takes.
    [[nodiscard]] double fullFrameMs(const gpu::VolumeScene& scene, const glm::ivec2& size);
    /// Sets the surface that is being refined, which scenes show from then on.
    void show(const core::SurfaceUpdate& surface);
    /// Draws the refined picture of a scene.
    [[nodiscard]] QImage draw(const gpu::VolumeScene& scene, const glm::ivec2& size,
        const gpu::SegmentDisplay& segments = {});

private:
    [[nodiscard]] gpu::Frame frame(const gpu::FrameRequest& request, gpu::Frame::Quality quality);

    core::LoadedVolume m_study;
    std::unique_ptr<gpu::GpuEngine> m_engine;
    std::unique_ptr<core::EditSession> m_session;
    int m_view = 0;
};

/// Measures of how a tool opened what lies under a curve on a view plane.
struct Opening {
    /// Fraction of the rays inside which meet the shell and find it removed completely.
    double cutThrough = 0.0;
    std::size_t carved = 0; ///< voxels
    std::size_t outside =
        0; ///< of them those more than a voxel (including diagonals) outside the sweep of the curve
    std::size_t touched = 0; ///< of them those that were to be spared
    std::size_t spared = 0; ///< all voxels that were to be spared
};

/// Marks the voxels behind a shell, under a curve, along the view.
/// @param gapMm thickness of other material that ends the shell
[[nodiscard]] std::vector<bool> behindShell(const core::VolumeGeometry& geometry,
    const core::OrthographicView& view, const std::vector<glm::dvec2>& polygonMm,
    const std::function<bool(std::size_t)>& isShell, double gapMm = 2.0);

/// A shell that differs from what lies behind it only by a band of high values: skin, fat and
/// marrow over a brain that is as bright as skin.
struct BandShell {
    std::vector<bool> over; ///< from the surface to the band's inner border
    std::vector<bool> behind; ///< from the lowest value after the band on
    double met = 0.0; ///< fraction of the rays inside the curve that meet a band
};

/// @param valueOf value of a voxel by its index in the study
/// @param surface least value of the surface
/// @param band least value of the band
[[nodiscard]] BandShell bandShell(const core::VolumeGeometry& geometry,
    const core::OrthographicView& view, const std::vector<glm::dvec2>& polygonMm,
    const std::function<double(std::size_t)>& valueOf, double surface, double band);

/// @param polygonMm in the view's plane, from its target
/// @param isShell, isSpared by the index of a voxel in the study
[[nodiscard]] Opening measureOpening(const core::VolumeGeometry& geometry,
    const std::vector<std::uint8_t>& coverage, const core::OrthographicView& view,
    const std::vector<glm::dvec2>& polygonMm, const std::function<bool(std::size_t)>& isShell,
    const std::function<bool(std::size_t)>& isSpared, double gapMm = 2.0);

} // namespace test
