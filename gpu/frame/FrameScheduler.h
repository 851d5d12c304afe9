// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/EditWorker.h"
#include "gpu/frame/FrameSource.h"
#include "gpu/frame/FrameTargets.h"
#include "gpu/frame/ViewPainter.h"
#include "gpu/gl/Fence.h"
#include "gpu/scene/SurfaceInbox.h"
#include "gpu/scene/TilePlan.h"

#include <array>
#include <bitset>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>

namespace gpu {

class VolumeTextures;

/// Draws what views ask for, in slices between which the engine thread serves edits and newer
/// requests. Per view: a coarse picture where a full one would take too long, a full one tile by
/// tile, then a finer one: in 3D more with the pixels' sampling points moved, averaged; what scenes
/// want interpolated by cubics is so only there. Then nothing until the request or the voxels
/// change.
///
/// request(), forget(), setListener(), updateSurface(): any thread. All else: the engine thread.
/// The listener must not wait for a thread that may be in forget().
class FrameScheduler : public FrameSource {
public:
    struct Options {
        VolumeTextures& volume;
        EditWorker& edits;
        const ShaderLibrary& shaders;
        std::function<void()> wake; ///< called by request()
    };
    /// Throws ShaderError.
    explicit FrameScheduler(const Options& options);
    ~FrameScheduler() override;

    void request(FrameRequest request) override;
    void forget(ViewId view) override;
    void setListener(Listener listener) override;
    void updateSurface(core::SurfaceUpdate update) override;

    /// One slice. @param editing edits are running: only coarse pictures meanwhile
    /// @return whether more is to do at once
    bool work(bool editing);

    /// Tiles drawn and frames handed out since the beginning; both stand still at rest.
    struct Counters {
        std::int64_t tiles = 0;
        std::int64_t frames = 0;
    };
    [[nodiscard]] const Counters& counters() const { return m_counters; }
    /// What was sent of the surface that is being refined.
    [[nodiscard]] const SurfaceBuffers::Counters& surfaceCounters() const
    {
        return m_painter.surface().counters();
    }

private:
    enum class Stage { Coarse, Full, Refine, Done };
    struct View {
        FrameRequest request;
        Stage stage = Stage::Done;
        int sample = 0; ///< of Refine
        std::optional<TilePlan> tiles; ///< of the picture being drawn; none: about to begin
        bool stale = false; ///< changed while its coarse picture was drawn
        double milliseconds = 0.0;
        std::uint64_t turn = 0;
        FrameTargets targets;
        ViewPictures pictures; ///< of the picture being drawn
    };
    struct Incoming {
        FrameRequest request;
        bool fresh = false; ///< forgotten before: nothing of the view's past counts
    };
    /// A tile that is being drawn while the next one is queued.
    struct Flying {
        ViewId view = 0;
        Fence fence;
        std::chrono::steady_clock::time_point queued;
        double pixels = 0.0;
        double* cost = nullptr; ///< of its kind, in m_cost; null: nothing to be learnt from it
    };
    /// A picture on its way from the GPU.
    struct Delivery {
        Frame frame;
        Fence fence;
    };

    [[nodiscard]] bool workUnguarded(bool editing);
    void giveUp(const core::Error& why);
    void hand(const Frame& frame);
    void takeRequests();
    void begin(View& view, FrameRequest request);
    void showPieces(const VolumeScene& scene);
    void takeChanges();
    void takeSurface();
    void changed(View& view);
    void restart(View& view);
    [[nodiscard]] View* next(bool editing);
    [[nodiscard]] bool wants(const View& view, bool editing) const;
    [[nodiscard]] bool isOverdue(const View& view) const;
    void drawSlice(View& view, bool editing);
    void land(); ///< waits for the flying tile
    void finishPicture(View& view);
    void warmUp(View& view);
    void readBack(View& view, Frame::Quality quality);
    bool deliver();
    [[nodiscard]] double& costOf(const View& view);
    [[nodiscard]] int coarseFactor(const View& view, bool editing);

    VolumeTextures& m_volume;
    EditWorker& m_edits;
    std::function<void()> m_wake;
    ViewPainter m_painter;
    Resolve m_resolve;
    Program m_cellKernel;
    std::bitset<256> m_shown;
    std::vector<PieceSource> m_shownPieces;
    std::optional<ToleranceDisplay> m_atTolerance;
    std::map<ViewId, View> m_views;
    std::map<ViewId, Delivery> m_deliveries;
    /// Milliseconds per megapixel: of slices, then by render mode; without cubics and with.
    std::array<std::array<double, 1 + renderModes>, 2> m_cost;
    std::optional<Flying> m_flying;
    bool m_contextLost = false; ///< and the edits know
    std::chrono::steady_clock::time_point m_landed; ///< when a tile was last done
    std::uint64_t m_turn = 0;
    Counters m_counters;

    std::mutex m_inboxMutex;
    std::map<ViewId, Incoming> m_inbox; ///< guarded; the latest per view
    std::set<ViewId> m_forgotten; ///< guarded
    SurfaceInbox m_surfaceInbox;
    std::mutex m_listenerMutex; ///< held while the listener runs
    Listener m_listener; ///< guarded by m_listenerMutex
};

} // namespace gpu
