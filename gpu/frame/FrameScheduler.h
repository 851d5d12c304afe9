// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/EditWorker.h"
#include "gpu/frame/FrameDelivery.h"
#include "gpu/frame/FrameMail.h"
#include "gpu/frame/TileCosts.h"
#include "gpu/frame/ViewProgress.h"
#include "gpu/gl/Fence.h"
#include "gpu/scene/SurfaceInbox.h"

#include <bitset>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace gpu {

class VolumeTextures;

/// Draws the pictures that views request, in slices between which the engine thread serves edits
/// and newer requests. Each view gets a coarse picture if a full one would take too long, then a
/// full one tile by tile, then a refined one: in 3D the average of several with moved sampling
/// points. Cubic interpolation, where a scene wants it, is used only for the refined picture. After
/// that nothing is drawn until the request or the voxels change. A coarse picture that has begun is
/// finished before a newer request of the same size begins.
///
/// request(), forget(), setListener() and updateSurface() may be called on any thread, all other
/// functions on the engine thread. The listener must not wait for a thread that may be in forget().
class FrameScheduler : public FrameSource {
public:
    struct Options {
        VolumeTextures& volume;
        EditWorker& edits;
        const ShaderLibrary& shaders;
        std::function<void()> wake; ///< called by request()
        /// Whether tiles become as large as those before them allow. If not, the same requests are
        /// drawn in the same tiles and coarseness on every machine.
        bool learnsCosts = true;
    };
    /// Throws ShaderError.
    explicit FrameScheduler(const Options& options);
    ~FrameScheduler() override;

    void request(FrameRequest request) override;
    void forget(ViewId view) override;
    void setListener(Listener listener) override;
    void updateSurface(core::SurfaceUpdate update) override;

    /// Does one slice of work.
    /// @param editing edits are running; only coarse pictures are drawn meanwhile
    bool work(bool editing);

    /// Tiles drawn and frames handed out since the beginning; both stand still at rest.
    struct Counters {
        std::int64_t tiles = 0;
        std::int64_t frames = 0;
    };
    [[nodiscard]] const Counters& counters() const { return m_counters; }
    /// What was sent to the GPU of the surface that is being refined.
    [[nodiscard]] const SurfaceBuffers::Counters& surfaceCounters() const
    {
        return m_painter.surface().counters();
    }

private:
    /// A tile that is being drawn while the next one is queued.
    struct Flying {
        ViewId view = 0;
        Fence fence;
        std::chrono::steady_clock::time_point queued;
        double pixels = 0.0;
        double* cost = nullptr; ///< entry of m_costs to update; null if this tile teaches nothing
    };

    [[nodiscard]] bool workUnguarded(bool editing);
    void giveUp(const core::Error& why);
    void takeRequests();
    void begin(ViewProgress& view, FrameRequest request);
    /// Begins what was requested while the coarse picture was drawn, if anything was.
    void beginAwaited(ViewProgress& view);
    void showPieces(const VolumeScene& scene);
    void takeChanges();
    void takeSurface();
    [[nodiscard]] ViewProgress* next(bool editing);
    void drawSlice(ViewProgress& view, bool editing);
    void land(); ///< waits for the tile that is being drawn
    void finishPicture(ViewProgress& view);
    void warmUp(ViewProgress& view);
    bool deliver();
    [[nodiscard]] double& costOf(const ViewProgress& view);

    VolumeTextures& m_volume;
    EditWorker& m_edits;
    std::function<void()> m_wake;
    bool m_learnsCosts;
    ViewPainter m_painter;
    Resolve m_resolve;
    Program m_cellKernel;
    std::bitset<256> m_shown;
    std::bitset<256> m_translucent;
    int m_bodiless = 0; ///< VolumeScene::bodiless of the last request of a 3D view
    std::vector<PieceSource> m_shownPieces;
    std::uint8_t m_growthPlane = 0;
    std::optional<ToleranceDisplay> m_atTolerance;
    std::map<ViewId, ViewProgress> m_views;
    TileCosts m_costs;
    std::optional<Flying> m_flying;
    bool m_contextLost = false; ///< and the edit engine knows
    std::chrono::steady_clock::time_point m_landed; ///< when the last tile was finished
    std::uint64_t m_turn = 0;
    Counters m_counters;

    // The next two may be used on any thread.
    FrameMail m_mail;
    SurfaceInbox m_surfaceInbox;
    bool m_surfaceWaits = false; ///< what it holds is not on the GPU yet

    FrameDelivery m_delivery; ///< delivers to m_mail; engine thread only
};

} // namespace gpu
