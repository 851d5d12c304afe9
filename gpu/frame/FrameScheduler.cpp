// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/FrameScheduler.h"

#include "core/base/Guarded.h"
#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/gl/GlFailure.h"
#include "gpu/scene/SceneReach.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

namespace gpu {

namespace {

using Clock = std::chrono::steady_clock;

/// Two tiles are under way at a time, one drawn and one queued, so that no processor waits for this
/// thread to wake up; together they are what an edit may have to wait for.
constexpr double sliceMilliseconds = 5.0;
constexpr double coarseMilliseconds = 40.0;
/// Of a coarse picture while edits run: they take about as long again. Under the pen it is drawn in
/// one slice, since an edit between its tiles would only show it later.
constexpr double editingMilliseconds = 20.0;
/// Slices that others may draw before it is this view's turn, whoever holds the pointer.
constexpr std::uint64_t longestWait = 8;
/// A full picture expected to be faster than this comes at once, without a coarse one before it.
constexpr double directMilliseconds = 90.0;
constexpr int accumulated = 8;
constexpr int coarsest = 6;

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
    , m_painter(options.volume, options.shaders)
    , m_resolve(options.shaders)
    , m_cellKernel(
          options.shaders, {.label = "macro-cells", .path = "fields/textures/macroCells.comp"})
{
    // Guesses of a software renderer; the first tiles correct them.
    m_cost[0] = {60.0, 500.0, 800.0, 800.0, 1500.0};
    m_cost[1] = {300.0, 800.0, 1100.0, 1100.0, 1800.0};
}

FrameScheduler::~FrameScheduler() = default;

void FrameScheduler::request(FrameRequest request)
{
    {
        const std::lock_guard lock(m_inboxMutex);
        const ViewId view = request.view;
        const bool fresh =
            m_forgotten.erase(view) > 0 || (m_inbox.contains(view) && m_inbox[view].fresh);
        m_inbox.insert_or_assign(view, Incoming{std::move(request), fresh});
    }
    if (m_wake)
        m_wake();
}

void FrameScheduler::forget(ViewId view)
{
    {
        const std::lock_guard lock(m_inboxMutex);
        m_inbox.erase(view);
        m_forgotten.insert(view);
    }
    // Whoever delivers looks at m_forgotten under this lock: after it nothing follows.
    const std::lock_guard wait(m_listenerMutex);
}

void FrameScheduler::setListener(Listener listener)
{
    const std::lock_guard lock(m_listenerMutex);
    m_listener = std::move(listener);
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
    const std::map<ViewId, Delivery> undelivered = std::exchange(m_deliveries, {});
    for (auto& [id, view] : m_views) {
        if (view.stage == Stage::Done && !undelivered.contains(id))
            continue;
        view.stage = Stage::Done;
        view.tiles.reset();
        view.stale = false;
        view.targets = {};
        view.pictures = {};
        hand({.view = id, .scene = view.request.scene, .failure = why});
    }
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
    if (View* view = next(editing)) {
        drawSlice(*view, editing);
        return true;
    }
    land();
    if (waiting) {
        m_deliveries.begin()->second.fence.wait();
        deliver();
    }
    return !m_deliveries.empty();
}

void FrameScheduler::takeRequests()
{
    std::map<ViewId, Incoming> inbox;
    std::set<ViewId> forgotten;
    {
        const std::lock_guard lock(m_inboxMutex);
        inbox.swap(m_inbox);
        forgotten = m_forgotten;
    }
    for (const ViewId view : forgotten) {
        m_views.erase(view);
        m_deliveries.erase(view);
    }
    for (auto& [id, incoming] : inbox) {
        if (incoming.fresh) {
            m_views.erase(id);
            m_deliveries.erase(id);
        }
        FrameRequest& request = incoming.request;
        if (request.sizePixels.x > 0 && request.sizePixels.y > 0)
            begin(m_views[id], std::move(request));
    }
}

void FrameScheduler::begin(View& view, FrameRequest request)
{
    const bool same = view.request.sizePixels == request.sizePixels
        && view.request.scene == request.scene && view.request.segments == request.segments;
    std::bitset<256> shown;
    for (std::size_t label = 1; label < 256; ++label)
        shown[label] = request.segments.visible[label];
    if (shown != m_shown) {
        m_shown = shown;
        m_edits.showSegments(shown);
    }
    if (request.segments.atTolerance != m_atTolerance) {
        m_atTolerance = request.segments.atTolerance;
        m_edits.showAtTolerance(m_atTolerance);
    }
    if (const auto* volume = std::get_if<VolumeScene>(&request.scene))
        showPieces(*volume);
    view.request = std::move(request);
    // The same picture again is no work, interacting or not.
    if (!same)
        restart(view);
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
        for (auto& [id, view] : m_views)
            restart(view);
    }
    if (!m_volume.isDrawable())
        return;
    const DirtyVoxels dirty{.labels = m_volume.takeDirty(VolumeField::Labels),
        .radiation = m_volume.takeDirty(VolumeField::Radiation),
        .segmentation = m_volume.takeDirty(VolumeField::Segmentation),
        .pieces = m_volume.takeDirty(VolumeField::Pieces),
        .barriers = m_volume.takeDirty(VolumeField::Barriers),
        .barrierBricks = m_volume.takeDirty(VolumeField::BarrierBricks),
        .foreseen = m_volume.takeDirty(VolumeField::Foreseen)};
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
            changed(view);
    }
}

void FrameScheduler::takeSurface()
{
    const std::optional<core::SurfaceUpdate> update = m_surfaceInbox.take();
    if (!update)
        return;
    m_painter.surface().apply(*update);
    m_painter.surface().upload();
    const WorldBox reach = m_painter.surface().takeChanged();
    for (auto& [id, view] : m_views) {
        if (showsSurface(view.request.scene, reach))
            changed(view);
    }
}

void FrameScheduler::changed(View& view)
{
    // A coarse picture under way is finished first, or a long edit would never show.
    if (view.stage == Stage::Coarse && view.tiles)
        view.stale = true;
    else
        restart(view);
}

void FrameScheduler::restart(View& view)
{
    view.stage = Stage::Coarse;
    view.tiles.reset();
    view.stale = false;
    view.sample = 0;
    view.milliseconds = 0.0;
}

bool FrameScheduler::wants(const View& view, bool editing) const
{
    if (view.stage == Stage::Done)
        return false;
    return view.stage == Stage::Coarse || !(view.request.interacting || editing);
}

bool FrameScheduler::isOverdue(const View& view) const
{
    return view.stage == Stage::Coarse && m_turn - view.turn > longestWait;
}

FrameScheduler::View* FrameScheduler::next(bool editing)
{
    View* best = nullptr;
    ViewId bestId = 0;
    for (auto& [id, view] : m_views) {
        if (!wants(view, editing))
            continue;
        if (best != nullptr && isOverdue(view) != isOverdue(*best)) {
            if (isOverdue(view)) {
                best = &view;
                bestId = id;
            }
            continue;
        }
        const bool better = best == nullptr || view.stage < best->stage
            || (view.stage == best->stage && view.request.interacting && !best->request.interacting)
            || (view.stage == best->stage && view.request.interacting == best->request.interacting
                && view.turn < best->turn);
        if (better) {
            best = &view;
            bestId = id;
        }
    }
    // Its buffer is still on the way home: that must arrive before the next picture.
    if (best != nullptr) {
        const auto pending = m_deliveries.find(bestId);
        if (pending != m_deliveries.end()) {
            pending->second.fence.wait();
            deliver();
        }
    }
    return best;
}

double& FrameScheduler::costOf(const View& view)
{
    const Scene& scene = view.request.scene;
    auto& cost = m_cost[view.stage == Stage::Refine && wantsCubics(scene) ? 1 : 0];
    if (const auto* volume = std::get_if<VolumeScene>(&scene))
        return cost[1 + std::size_t(volume->mode)];
    return cost[0];
}

int FrameScheduler::coarseFactor(const View& view, bool editing)
{
    const glm::dvec2 size(view.request.sizePixels);
    const double expected = costOf(view) * size.x * size.y * 1e-6;
    const double wanted = editing ? editingMilliseconds : coarseMilliseconds;
    const bool patient = !view.request.interacting && !editing;
    if (expected <= (patient ? directMilliseconds : wanted))
        return 1;
    return std::clamp(int(std::ceil(std::sqrt(expected / wanted))), 1, coarsest);
}

void FrameScheduler::drawSlice(View& view, bool editing)
{
    const Clock::time_point start = Clock::now();
    view.turn = ++m_turn;
    view.targets.resize(view.request.sizePixels);
    if (!m_volume.isDrawable()) {
        view.targets.picture.clear();
        view.stage = Stage::Done;
        readBack(view, Frame::Quality::Refined);
        return;
    }
    const bool begins = !view.tiles;
    if (begins) {
        const int factor = view.stage == Stage::Coarse ? coarseFactor(view, editing) : 1;
        view.tiles.emplace((view.request.sizePixels + (factor - 1)) / factor);
        view.milliseconds = 0.0;
    }
    double& cost = costOf(view);
    // While edits run one tile is under way, not two.
    const double budget = !editing ? sliceMilliseconds
        : view.request.interacting ? editingMilliseconds
                                   : 2.0 * sliceMilliseconds;
    const Tile tile = view.tiles->take(budget / cost * 1e6);
    const PassTarget target{
        .frameSize = view.request.sizePixels,
        .pixelScale = float(view.request.sizePixels.x) / float(view.tiles->size().x),
        .pixelJitter = pixelJitter(view.sample),
        .sample = view.sample,
        .cubic = view.stage == Stage::Refine,
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
    if (!tile.cost)
        return;
    // Follows slowly and by bounded steps: a first use compiles, a corner may be empty.
    double& cost = *tile.cost;
    const double measured = spent.count() / tile.pixels * 1e6;
    cost = std::clamp(0.7 * cost + 0.3 * measured, 0.5 * cost, 2.0 * cost);
}

void FrameScheduler::finishPicture(View& view)
{
    land();
    const Clock::time_point start = Clock::now();
    const glm::ivec2 drawn = view.tiles->size();
    view.tiles.reset();
    const bool flat = std::holds_alternative<SliceScene>(view.request.scene);
    const bool cubics = wantsCubics(view.request.scene);
    if (view.stage == Stage::Refine && !flat && view.sample + 1 < accumulated) {
        ++view.sample;
        return;
    }
    m_resolve.draw(view.targets, view.sample + 1, drawn, m_painter.noVertices());
    // What could be drawn whole at once needs no second time.
    if (view.stage == Stage::Coarse && drawn == view.targets.size)
        view.stage = Stage::Full;
    Frame::Quality quality = Frame::Quality::Full;
    switch (view.stage) {
    case Stage::Coarse:
        quality = Frame::Quality::Coarse;
        view.stage = Stage::Full;
        break;
    case Stage::Full:
        quality = flat && !cubics ? Frame::Quality::Refined : Frame::Quality::Full;
        view.stage = flat && !cubics ? Stage::Done : Stage::Refine;
        // With cubics the first of the pictures is another one, too.
        view.sample = cubics || flat ? 0 : 1;
        break;
    case Stage::Refine:
    case Stage::Done:
        quality = Frame::Quality::Refined;
        view.stage = Stage::Done;
        break;
    }
    view.milliseconds += since(start);
    readBack(view, quality);
    if (quality == Frame::Quality::Refined)
        warmUp(view);
    if (view.stale)
        restart(view);
}

void FrameScheduler::warmUp(View& view)
{
    const auto* scene = std::get_if<VolumeScene>(&view.request.scene);
    if (scene == nullptr || !m_volume.isDrawable())
        return;
    // One pixel of the sum, which the next picture begins anew.
    view.targets.sumFrame.bind();
    m_painter.warmUp(*scene, view.request.sizePixels);
    m_edits.warmUp();
}

void FrameScheduler::readBack(View& view, Frame::Quality quality)
{
    view.targets.pictureFrame.readInto(view.targets.home.id());
    Delivery delivery;
    delivery.frame = Frame{
        .view = view.request.view,
        .sizePixels = view.targets.size,
        .rgba = nullptr,
        .quality = quality,
        .renderMilliseconds = view.milliseconds,
        .pieces = {},
        .scene = view.request.scene,
    };
    if (const auto* scene = std::get_if<VolumeScene>(&view.request.scene)) {
        for (const ScenePiece& piece : scene->pieces) {
            const auto* entry = m_volume.pieces().entry({piece.layer, piece.segment});
            if (piece.id != 0 && entry && !entry->filled.empty())
                delivery.frame.pieces.push_back({.id = piece.id, .filled = entry->filled});
        }
    }
    delivery.fence = Fence::insert();
    m_deliveries.insert_or_assign(view.request.view, std::move(delivery));
}

bool FrameScheduler::deliver()
{
    for (auto it = m_deliveries.begin(); it != m_deliveries.end();) {
        if (!it->second.fence.passed()) {
            ++it;
            continue;
        }
        requireContext(); // else what lies there is no picture
        Frame frame = std::move(it->second.frame);
        const auto view = m_views.find(it->first);
        it = m_deliveries.erase(it);
        if (view == m_views.end())
            continue;
        const Buffer& home = view->second.targets.home;
        std::vector<std::uint8_t> bytes(home.bytes());
        std::memcpy(bytes.data(), home.mapped(), bytes.size());
        frame.rgba = std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
        ++m_counters.frames;
        hand(frame);
    }
    return !m_deliveries.empty();
}

void FrameScheduler::hand(const Frame& frame)
{
    const std::lock_guard listening(m_listenerMutex);
    bool wanted = true;
    {
        const std::lock_guard lock(m_inboxMutex);
        wanted = !m_forgotten.contains(frame.view);
    }
    if (wanted && m_listener)
        m_listener(frame);
}

} // namespace gpu
