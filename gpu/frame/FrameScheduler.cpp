// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/FrameScheduler.h"

#include "core/base/Guarded.h"
#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/gl/GlFailure.h"
#include "gpu/scene/DirtyVoxels.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace gpu {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Points spread evenly over the pixel (Halton 2, 3), centred; the first is the centre.
glm::vec2 pixelJitter(int sample)
{
    const auto radicalInverse = [](int base, int n) {
        double result = 0.0;
        for (double digit = 1.0 / base; n > 0; n /= base, digit /= base)
            result += digit * (n % base);
        return result;
    };
    if (sample == 0)
        return glm::vec2(0.0f);
    return glm::vec2(radicalInverse(2, sample) - 0.5, radicalInverse(3, sample) - 0.5);
}

} // namespace

FrameScheduler::FrameScheduler(const Options& options)
    : m_volume(options.volume)
    , m_edits(options.edits)
    , m_wake(options.wake)
    , m_learnsCosts(options.learnsCosts)
    , m_painter(options.volume, options.shaders)
    , m_resolve(options.shaders)
    , m_cellKernel(
          options.shaders, {.label = "macro-cells", .path = "fields/textures/macroCells.comp"})
    , m_delivery(options.volume, m_mail)
{
}

FrameScheduler::~FrameScheduler() = default;

void FrameScheduler::request(FrameRequest request)
{
    m_mail.request(std::move(request));
    if (m_wake)
        m_wake();
}

void FrameScheduler::forget(ViewId view)
{
    m_mail.forget(view);
}

void FrameScheduler::setListener(Listener listener)
{
    m_mail.setListener(std::move(listener));
}

void FrameScheduler::updateSurface(core::SurfaceUpdate update)
{
    m_surfaceInbox.put(std::move(update));
    if (m_wake)
        m_wake();
}

bool FrameScheduler::work(bool editing)
{
    try {
        const bool more = workUnguarded(editing);
        requireNoError();
        return more;
    } catch (const std::exception&) {
        const core::Error error = errorBeingHandled();
        // Where there is no memory to say so either, the next request begins anew.
        static_cast<void>(core::guarded([&] { giveUp(error); }));
        // The edits look for it in the thread's next turn, and tell it.
        if (error.code == core::ErrorCode::ContextLost && !std::exchange(m_contextLost, true)
            && m_wake)
            m_wake();
        return false;
    }
}

/// Of no picture under way is it known what it shows. The next request or change begins anew.
void FrameScheduler::giveUp(const core::Error& why)
{
    m_flying.reset();
    for (auto& [id, view] : m_views) {
        if (view.stage == ViewProgress::Stage::Done && !m_delivery.contains(id))
            continue;
        m_delivery.forget(id);
        view.giveUp();
        m_mail.hand({.view = id, .scene = view.request.scene, .failure = why});
    }
    m_delivery.clear();
}

bool FrameScheduler::workUnguarded(bool editing)
{
    takeRequests();
    takeChanges();
    takeSurface();
    const bool waiting = deliver();
    // An edit ran since it was queued: how long the tile itself took is not known.
    if (editing && m_flying)
        m_flying->cost = nullptr;
    if (ViewProgress* view = next(editing)) {
        drawSlice(*view, editing);
        return true;
    }
    land();
    if (waiting) {
        m_delivery.awaitFirst();
        deliver();
    }
    return !m_delivery.empty();
}

void FrameScheduler::takeRequests()
{
    FrameMail::Letters letters = m_mail.take();
    for (const ViewId view : letters.forgotten) {
        m_views.erase(view);
        m_delivery.forget(view);
    }
    for (auto& [id, incoming] : letters.requests) {
        if (incoming.fresh) {
            m_views.erase(id);
            m_delivery.forget(id);
        }
        FrameRequest& request = incoming.request;
        if (request.sizePixels.x > 0 && request.sizePixels.y > 0)
            begin(m_views[id], std::move(request));
    }
}

void FrameScheduler::begin(ViewProgress& view, FrameRequest request)
{
    const bool same = view.request.sizePixels == request.sizePixels
        && view.request.scene == request.scene && view.request.segments == request.segments;
    // A coarse picture under way is finished first: a hand that moves asks for the next picture
    // before this one is done, and would otherwise see none.
    if (!same && view.drawsCoarse() && view.request.sizePixels == request.sizePixels) {
        view.awaited = std::move(request);
        return;
    }
    view.awaited.reset();
    std::bitset<256> shown;
    std::bitset<256> translucent;
    for (std::size_t label = 1; label < 256; ++label) {
        shown[label] = request.segments.visible[label];
        translucent[label] = shown[label] && request.segments.transparencyPercent[label] > 0;
    }
    // Slices draw no bodies: they leave it as the 3D view wants it.
    if (const auto* volume = std::get_if<VolumeScene>(&request.scene))
        m_bodiless = volume->bodiless;
    if (m_bodiless > 0 && m_bodiless < 256)
        shown[std::size_t(m_bodiless)] = false;
    if (shown != m_shown || translucent != m_translucent) {
        m_shown = shown;
        m_translucent = translucent;
        m_edits.showSegments(shown, translucent);
    }
    if (request.segments.growthPlane != m_growthPlane) {
        m_growthPlane = request.segments.growthPlane;
        m_edits.showGrowth(m_growthPlane);
    }
    if (request.segments.atTolerance != m_atTolerance) {
        m_atTolerance = request.segments.atTolerance;
        m_edits.showAtTolerance(m_atTolerance);
    }
    if (const auto* volume = std::get_if<VolumeScene>(&request.scene))
        showPieces(*volume);
    view.request = std::move(request);
    // The same picture again is no work, interacting or not, unless there is none.
    if (!same || view.failed)
        view.restart();
}

void FrameScheduler::showPieces(const VolumeScene& scene)
{
    std::vector<PieceSource> sources;
    for (const ScenePiece& piece : scene.pieces)
        sources.push_back({piece.layer, piece.segment});
    std::sort(sources.begin(), sources.end());
    sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
    if (sources == m_shownPieces)
        return;
    m_shownPieces = std::move(sources);
    m_edits.showPieces(m_shownPieces);
}

void FrameScheduler::takeChanges()
{
    // What changed since the volume was opened (a session that continues) stays to be taken in.
    if (m_volume.takeReplaced()) {
        for (auto& [id, view] : m_views) {
            view.restart();
            beginAwaited(view);
        }
    }
    if (!m_volume.isDrawable())
        return;
    const DirtyVoxels dirty{.labels = m_volume.takeDirty(VolumeField::Labels),
        .radiation = m_volume.takeDirty(VolumeField::Radiation),
        .segmentation = m_volume.takeDirty(VolumeField::Segmentation),
        .pieces = m_volume.takeDirty(VolumeField::Pieces),
        .barriers = m_volume.takeDirty(VolumeField::Barriers),
        .barrierBricks = m_volume.takeDirty(VolumeField::BarrierBricks),
        .cutPreview = m_volume.takeDirty(VolumeField::CutPreview)};
    if (dirty.empty())
        return;
    const core::VoxelBox box = dirty.radiation.united(dirty.segmentation);
    try {
        m_volume.cells().update(m_cellKernel, m_volume.radiation(), m_volume.segmentation(), box);
    } catch (const std::exception&) {
        m_volume.markDirty(VolumeField::Radiation, box);
        throw;
    }
    for (auto& [id, view] : m_views) {
        if (showsChange(view.request.scene, m_volume.geometry(), dirty))
            view.changed();
    }
}

void FrameScheduler::takeSurface()
{
    const std::optional<core::SurfaceUpdate> update = m_surfaceInbox.take();
    if (update)
        m_painter.surface().apply(*update);
    else if (!m_surfaceWaits)
        return;
    m_surfaceWaits = true; // for memory, if there is none now
    m_painter.surface().upload();
    m_surfaceWaits = false;
    const WorldBox reach = m_painter.surface().takeChanged();
    for (auto& [id, view] : m_views) {
        if (showsSurface(view.request.scene, reach))
            view.changed();
    }
}

ViewProgress* FrameScheduler::next(bool editing)
{
    ViewProgress* best = nullptr;
    ViewId bestId = 0;
    for (auto& [id, view] : m_views) {
        if (view.wants(editing) && (best == nullptr || view.comesBefore(*best, m_turn))) {
            best = &view;
            bestId = id;
        }
    }
    // Its buffer is still on the way home: that must arrive before the next picture.
    if (best != nullptr && m_delivery.contains(bestId)) {
        m_delivery.await(bestId);
        deliver();
    }
    return best;
}

double& FrameScheduler::costOf(const ViewProgress& view)
{
    const Scene& scene = view.request.scene;
    return m_costs.of(scene, view.stage == ViewProgress::Stage::Refine && wantsCubics(scene));
}

void FrameScheduler::drawSlice(ViewProgress& view, bool editing)
{
    const Clock::time_point start = Clock::now();
    view.turn = ++m_turn;
    if (!view.begun)
        view.begun = start;
    view.targets.resize(view.request.sizePixels);
    if (!m_volume.isDrawable()) {
        view.targets.picture.clear();
        view.stage = ViewProgress::Stage::Done;
        m_delivery.send(view, Frame::Quality::Refined);
        return;
    }
    const bool begins = !view.tiles;
    if (begins) {
        const int factor = view.stage == ViewProgress::Stage::Coarse
            ? TileCosts::coarseFactor(
                costOf(view), view.request.sizePixels, editing, view.request.interacting)
            : 1;
        view.tiles.emplace((view.request.sizePixels + (factor - 1)) / factor);
        view.milliseconds = 0.0;
    }
    double& cost = costOf(view);
    const Tile tile =
        view.tiles->take(TileCosts::pixelsAtOnce(cost, editing, view.request.interacting));
    const PassTarget target{
        .frameSize = view.request.sizePixels,
        .pixelScale = float(view.request.sizePixels.x) / float(view.tiles->size().x),
        .pixelJitter = pixelJitter(view.sample),
        .sample = view.sample,
        .cubic = view.stage == ViewProgress::Stage::Refine,
    };
    const bool surface = begins && m_painter.begin(view.pictures, view.request.scene, target);
    m_painter.draw(
        view.pictures, view.request, target, tile, view.targets.sumFrame, view.sample > 0);
    Flying drawn{.view = view.request.view,
        .fence = Fence::insert(),
        .queued = start,
        .pixels = double(tile.size.x) * tile.size.y,
        .cost = surface || m_painter.takeChunksChanged() ? nullptr : &cost};
    glFlush();
    land();
    m_flying.emplace(std::move(drawn));
    ++m_counters.tiles;
    if (editing)
        land();
    if (view.tiles->finished())
        finishPicture(view);
}

void FrameScheduler::land()
{
    if (!m_flying)
        return;
    const Flying tile = std::move(*m_flying);
    m_flying.reset();
    tile.fence.wait();
    const Clock::time_point now = Clock::now();
    // Its own time began when the tile before it was done.
    const std::chrono::duration<double, std::milli> spent = now - std::max(tile.queued, m_landed);
    m_landed = now;
    const auto view = m_views.find(tile.view);
    if (view != m_views.end())
        view->second.milliseconds += spent.count();
    if (tile.cost && m_learnsCosts)
        TileCosts::learn(*tile.cost, spent.count(), tile.pixels);
}

void FrameScheduler::finishPicture(ViewProgress& view)
{
    land();
    const Clock::time_point start = Clock::now();
    const glm::ivec2 drawn = view.tiles->size();
    view.tiles.reset();
    if (view.goesOnToNextSample())
        return;
    m_resolve.draw(view.targets, view.sample + 1, drawn, m_painter.noVertices());
    const Frame::Quality quality = view.finishStage(drawn);
    view.milliseconds += since(start);
    m_delivery.send(view, quality);
    if (quality == Frame::Quality::Refined && !view.request.single)
        warmUp(view);
    if (view.stale)
        view.restart();
    beginAwaited(view);
}

void FrameScheduler::beginAwaited(ViewProgress& view)
{
    if (std::optional<FrameRequest> request = std::exchange(view.awaited, std::nullopt))
        begin(view, *std::move(request));
}

void FrameScheduler::warmUp(ViewProgress& view)
{
    const auto* scene = std::get_if<VolumeScene>(&view.request.scene);
    if (scene == nullptr || !m_volume.isDrawable())
        return;
    // One pixel of the sum, which the next picture begins anew.
    view.targets.sumFrame.bind();
    m_painter.warmUp(*scene, view.request.sizePixels);
    m_edits.warmUp();
}

bool FrameScheduler::deliver()
{
    m_counters.frames += m_delivery.deliver(m_views);
    return !m_delivery.empty();
}

} // namespace gpu
