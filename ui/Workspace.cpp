// SPDX-License-Identifier: Apache-2.0
#include "ui/Workspace.h"

#include <utility>

namespace ui {

Workspace::Workspace(gpu::FrameSource& frames, QObject* parent)
    : QObject(parent)
    , m_frames(frames)
{
}

Workspace::~Workspace() = default;

const core::Volume* Workspace::volume() const
{
    if (!m_session || m_session->document().volumes.empty())
        return nullptr;
    return &m_session->document().volumes.front();
}

void Workspace::setSession(std::unique_ptr<core::EditSession> session)
{
    if (m_session)
        m_session->setListener({});
    m_session = std::move(session);
    if (m_session) {
        m_session->setListener(
            [this](const core::DocumentChange& change) { Q_EMIT documentChanged(change); });
    }
    Q_EMIT sessionChanged();
}

void Workspace::setCrosshairLps(const glm::dvec3& position)
{
    if (position == m_crosshairLps)
        return;
    m_crosshairLps = position;
    Q_EMIT crosshairChanged();
}

void Workspace::setWindowLevel(const core::WindowLevel& window)
{
    if (window == m_windowLevel)
        return;
    m_windowLevel = window;
    Q_EMIT windowLevelChanged();
}

void Workspace::setActiveSegment(int label)
{
    if (label == m_activeSegment)
        return;
    m_activeSegment = label;
    Q_EMIT activeSegmentChanged();
}

void Workspace::setVolumeDisplay(const VolumeDisplay& display)
{
    if (display == m_volumeDisplay)
        return;
    m_volumeDisplay = display;
    Q_EMIT volumeDisplayChanged();
}

gpu::SegmentDisplay Workspace::segmentDisplay() const
{
    gpu::SegmentDisplay display;
    if (!m_session)
        return display;
    for (const core::Segment& segment : m_session->document().segments) {
        display.rgb[segment.label] = segment.rgb;
        display.visible[segment.label] = segment.visible;
    }
    return display;
}

void Workspace::setDrillSettings(const DrillSettings& settings)
{
    if (settings == m_drill)
        return;
    m_drill = settings;
    Q_EMIT drillSettingsChanged();
}

void Workspace::setGrowSettings(const GrowSettings& settings)
{
    if (settings == m_grow)
        return;
    m_grow = settings;
    Q_EMIT growSettingsChanged();
}

void Workspace::setActiveTool(Tool* tool)
{
    if (tool == m_tool)
        return;
    m_tool = tool;
    Q_EMIT activeToolChanged();
}

} // namespace ui
