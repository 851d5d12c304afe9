// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/EditSession.h"
#include "gpu/engine/GpuEngine.h"

#include <QImage>

#include <functional>
#include <memory>
#include <vector>

namespace test {

/// A study on the real engine, to be sculpted and looked at.
class SculptStage {
public:
    explicit SculptStage(core::LoadedVolume study);

    [[nodiscard]] bool isReady() const { return bool(m_session); }
    [[nodiscard]] const core::LoadedVolume& study() const { return m_study; }
    [[nodiscard]] core::EditSession& session() { return *m_session; }
    /// Applies and waits. @return empty, or what was wrong
    [[nodiscard]] QString apply(const core::Edit& edit);
    /// The coverage of a sculpt layer, or a label plane: x fastest.
    [[nodiscard]] std::vector<std::uint8_t> voxels(core::Field field, std::uint8_t plane);
    /// Of a voxel of the study in such a list.
    [[nodiscard]] std::size_t placeOf(const glm::ivec3& voxel) const;
    /// The voxels that are seen in the 3D view, as a seed stroke finds them: along a path in the
    /// view plane, each once.
    [[nodiscard]] std::vector<glm::ivec3> seenVoxels(
        const gpu::VolumeScene& scene, const std::vector<glm::dvec2>& pathMm);
    /// What the first picture of full resolution takes.
    [[nodiscard]] double fullFrameMs(const gpu::VolumeScene& scene, const glm::ivec2& size);
    /// The surface that is refined, as scenes show it from then on.
    void show(const core::SurfaceUpdate& surface);
    /// The finest picture.
    [[nodiscard]] QImage draw(const gpu::VolumeScene& scene, const glm::ivec2& size,
        const gpu::SegmentDisplay& segments = {});

private:
    [[nodiscard]] gpu::Frame frame(const gpu::FrameRequest& request, gpu::Frame::Quality quality);

    core::LoadedVolume m_study;
    std::unique_ptr<gpu::GpuEngine> m_engine;
    std::unique_ptr<core::EditSession> m_session;
    int m_view = 0;
};

/// How a curve on a view plane opened what lies under it.
struct Opening {
    double cutThrough = 0.0; ///< of the rays inside that meet the shell: it is gone all the way
    std::size_t carved = 0; ///< voxels
    std::size_t outside =
        0; ///< of them more than a voxel, diagonals included, beside the curve's sweep
    std::size_t touched = 0; ///< of them such as are to be spared
    std::size_t spared = 0; ///< all of those
};

/// What lies behind a shell, under a curve, as the view sees it.
/// @param gapMm so much of something else ends the shell
[[nodiscard]] std::vector<bool> behindShell(const core::VolumeGeometry& geometry,
    const core::OrthographicView& view, const std::vector<glm::dvec2>& polygonMm,
    const std::function<bool(std::size_t)>& isShell, double gapMm = 2.0);

/// A shell that is told from what lies behind it only by a band of high values: of skin, fat and
/// marrow over a brain that is as bright as skin.
struct BandShell {
    std::vector<bool> over; ///< from the surface to the band's inner border
    std::vector<bool> behind; ///< from the lowest value after the band on
    double met = 0.0; ///< of the rays inside the curve: they come to a band
};

/// @param valueOf of a voxel's place in the study
/// @param surface the surface's least value
/// @param band the band's
[[nodiscard]] BandShell bandShell(const core::VolumeGeometry& geometry,
    const core::OrthographicView& view, const std::vector<glm::dvec2>& polygonMm,
    const std::function<double(std::size_t)>& valueOf, double surface, double band);

/// @param polygonMm in the view's plane, from its target
/// @param isShell, isSpared of a voxel's place in the study
[[nodiscard]] Opening measureOpening(const core::VolumeGeometry& geometry,
    const std::vector<std::uint8_t>& coverage, const core::OrthographicView& view,
    const std::vector<glm::dvec2>& polygonMm, const std::function<bool(std::size_t)>& isShell,
    const std::function<bool(std::size_t)>& isSpared, double gapMm = 2.0);

} // namespace test
