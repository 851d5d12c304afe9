// SPDX-License-Identifier: Apache-2.0
#include "app/steps/RunKeyframes.h"

#include "app/steps/SteadySession.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/history/MovedGrowth.h"
#include "core/session/SessionKeyframes.h"
#include "gpu/engine/GpuEngine.h"
#include "gpu/frame/FrameSource.h"
#include "ui/workspace/InitialDisplay.h"
#include "ui/workspace/OpeningView.h"

#include <chrono>

namespace app {

namespace {

constexpr gpu::ViewId view = 0;
constexpr QSize size = ui::KeyframeRule::pictureSize;
/// A picture is no truth: the work does not hang on it.
constexpr std::chrono::seconds longest{30};

/// The label plane of the growth that the last step was about.
std::uint8_t growthPlaneOfLast(const core::History& history)
{
    if (history.position() == 0)
        return 0;
    const core::Edit& edit = history.row(history.position()).edit;
    const auto* barrier = edit.as<core::BarrierStroke>();
    return barrier ? core::growthPlaneOf(barrier->plane) : core::recordedGrowthPlane(edit, history);
}

} // namespace

RunKeyframes::RunKeyframes(SteadySession& session)
    : m_frames(session.engine().frames())
    , m_session(session)
    , m_rows(session.rowCount())
{
    core::EditSession& open = session.session();
    m_rule.begin(m_rows, open.history().position(), !open.keyframes().rows().empty(),
        ui::steadyMilliseconds());
    m_frames.setListener([this](const gpu::Frame& frame) { take(frame); });
}

RunKeyframes::~RunKeyframes()
{
    m_frames.setListener({});
}

void RunKeyframes::follow()
{
    const std::size_t rows = m_session.rowCount();
    const bool committed = rows > m_rows;
    m_rows = rows;
    if (committed && m_rule.dueAfterStep(rows, ui::steadyMilliseconds()))
        keep();
}

void RunKeyframes::close()
{
    if (m_rule.dueAtEnd(m_session.session().history().position()))
        keep();
}

/// On the engine's thread.
void RunKeyframes::take(const gpu::Frame& frame)
{
    const bool last = frame.failure || frame.quality == gpu::Frame::Quality::Refined;
    if (frame.view != view || !last)
        return;
    {
        const std::lock_guard lock(m_mutex);
        m_picture = frame.rgba;
        m_answered = true;
    }
    m_arrived.notify_one();
}

void RunKeyframes::keep()
{
    core::EditSession& session = m_session.session();
    const core::Document& document = session.document();
    const core::Volume& volume = document.volumes.front();
    ui::Camera camera = ui::openingCamera(volume.geometry);
    camera.heightMm = ui::fittingHeightMm(camera, volume.geometry, size);
    gpu::SegmentDisplay segments = ui::segmentDisplay(document);
    segments.growthPlane = growthPlaneOfLast(session.history());
    gpu::VolumeScene scene = ui::volumeScene(camera, ui::initialVolumeDisplay(volume));
    for (const core::Piece& piece : document.pieces)
        scene.pieces.push_back(ui::scenePiece(piece, document));
    {
        // A picture that came too late for the row before is none of this one.
        const std::lock_guard lock(m_mutex);
        m_picture.reset();
        m_answered = false;
    }
    m_frames.request({.view = view,
        .sizePixels = {size.width(), size.height()},
        .scene = scene,
        .segments = segments,
        .single = true});
    std::shared_ptr<const std::vector<std::uint8_t>> picture;
    {
        std::unique_lock lock(m_mutex);
        m_arrived.wait_for(lock, longest, [this] { return m_answered; });
        picture.swap(m_picture);
        m_answered = false;
    }
    // Else every later step would be drawn too.
    m_frames.forget(view);
    const core::RowId row = session.history().position();
    m_rule.kept(row, m_rows, ui::steadyMilliseconds());
    if (!picture)
        return;
    const QImage image(
        picture->data(), size.width(), size.height(), 4 * size.width(), QImage::Format_RGBX8888);
    session.keyframes().add(row, ui::keyframePng(image));
}

} // namespace app
