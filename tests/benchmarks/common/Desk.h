// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/EditSession.h"
#include "core/volume/Volume.h"
#include "gpu/engine/GpuEngine.h"
#include "tests/benchmarks/common/WatchedViews.h"

#include <QByteArray>

#include <cstdint>
#include <memory>
#include <vector>

namespace bench {

/// The state of a session, and what its 3D view shows of it.
struct Seen {
    QByteArray hash;
    std::vector<std::uint8_t> stage;
    bool operator==(const Seen&) const = default;
};

/// A session with the views of a window: a 3D view of 1230 × 870 pixels and three slices of 400 ×
/// 400, which show segment 1.
class Desk {
public:
    static constexpr gpu::ViewId stage = 1; ///< the 3D view
    static constexpr gpu::ViewId firstSlice = 2;
    [[nodiscard]] static std::vector<gpu::ViewId> all();

    /// @param crossing the place through which the slices go
    /// @return null: there is no engine, or not enough memory
    static std::unique_ptr<Desk> open(
        const core::LoadedVolume& study, const gpu::VolumeScene& scene, const glm::dvec3& crossing);

    [[nodiscard]] core::EditSession& session() { return *m_session; }
    [[nodiscard]] WatchedViews& views() { return m_views; }
    [[nodiscard]] gpu::GpuEngine& engine() { return *m_engine; }

    /// Whether something moves, so that the 3D view asks for moving pictures.
    void move(bool moving);
    /// Carries out an edit, and waits until that is done.
    /// @return whether it was carried out
    bool apply(const core::Edit& edit);
    bool end(core::Ending ending = core::Ending::Commit);
    bool undo();
    [[nodiscard]] core::Edit lastEdit() const { return m_session->history().rows().back().edit; }
    /// At rest, not moving. Nothing may stand open.
    [[nodiscard]] Seen seen();
    /// The last picture of each view, the 3D view first; at rest, whatever stands open.
    [[nodiscard]] std::vector<std::vector<std::uint8_t>> pictures();

private:
    Desk(std::unique_ptr<gpu::GpuEngine> engine, gpu::VolumeScene scene);
    [[nodiscard]] static gpu::SegmentDisplay segments();
    void showSlices(const glm::dvec3& crossing);

    std::unique_ptr<gpu::GpuEngine> m_engine;
    WatchedViews m_views;
    gpu::VolumeScene m_scene;
    std::unique_ptr<core::EditSession> m_session;
};

} // namespace bench
