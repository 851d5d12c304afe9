// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/common/Desk.h"

#include <chrono>
#include <utility>

namespace bench {

std::unique_ptr<Desk> Desk::open(
    const core::LoadedVolume& study, const gpu::VolumeScene& scene, const glm::dvec3& crossing)
{
    auto engine = gpu::GpuEngine::create();
    if (!engine)
        return nullptr;
    std::unique_ptr<Desk> desk(new Desk(*std::move(engine), scene));
    auto session = core::EditSession::create(desk->m_engine->edits(), study,
        {.file = {}, .wakeUp = [views = &desk->m_views] { views->wake(); }});
    if (!session)
        return nullptr;
    desk->m_session = *std::move(session);
    desk->m_engine->setVolumeGeometry(study.volume.geometry, study.volume.encoding);
    desk->m_views.setPoll([raw = desk.get()] { raw->m_session->poll(); });
    desk->showSlices(crossing);
    desk->move(false);
    return desk;
}

Desk::Desk(std::unique_ptr<gpu::GpuEngine> engine, gpu::VolumeScene scene)
    : m_engine(std::move(engine))
    , m_views(*m_engine)
    , m_scene(std::move(scene))
{
}

void Desk::move(bool moving)
{
    m_views.show({.view = stage,
        .sizePixels = {1230, 870},
        .scene = m_scene,
        .segments = segments(),
        .interacting = moving});
}

bool Desk::apply(const core::Edit& edit)
{
    return bool(m_session->apply(edit)) && bool(m_session->settle());
}

bool Desk::end(core::Ending ending)
{
    m_session->end(ending);
    return bool(m_session->settle());
}

bool Desk::undo()
{
    return bool(m_session->undo()) && bool(m_session->settle());
}

Seen Desk::seen()
{
    move(false);
    Seen now;
    if (m_session->settle())
        now.hash = m_session->stateHash();
    now.stage = pictures().front();
    return now;
}

std::vector<gpu::ViewId> Desk::all()
{
    return {stage, firstSlice, firstSlice + 1, firstSlice + 2};
}

std::vector<std::vector<std::uint8_t>> Desk::pictures()
{
    // After much has changed the textures of the picture follow only after a while.
    m_views.rest(std::chrono::seconds(3));
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const gpu::ViewId view : all()) {
        const gpu::Frame frame = m_views.latest(view);
        pictures.push_back(frame.rgba ? *frame.rgba : std::vector<std::uint8_t>());
    }
    return pictures;
}

gpu::SegmentDisplay Desk::segments()
{
    gpu::SegmentDisplay display;
    display.visible[1] = true;
    display.rgb[1] = 0x59C07A;
    return display;
}

void Desk::showSlices(const glm::dvec3& crossing)
{
    for (int axis = 0; axis < 3; ++axis) {
        gpu::SliceScene scene;
        scene.centreLps = crossing;
        scene.rightLps = axis == 0 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
        scene.downLps = axis == 2 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, -1.0);
        scene.mmPerPixel = m_scene.heightMm / 400.0;
        scene.window = {.centre = 1000.0, .width = 2000.0};
        m_views.show({.view = firstSlice + axis,
            .sizePixels = {400, 400},
            .scene = scene,
            .segments = segments()});
    }
}

} // namespace bench
