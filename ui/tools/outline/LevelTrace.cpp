// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/outline/LevelTrace.h"

#include "ui/tools/outline/ReadSlice.h"
#include "ui/workspace/Workspace.h"

#include <utility>

namespace ui {

LevelTrace::LevelTrace(Workspace& workspace, ReadSlice& slice, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_slice(slice)
{
    connect(&slice, &ReadSlice::dropped, this, &LevelTrace::drop);
    connect(&slice, &ReadSlice::arrived, this, &LevelTrace::proceed);
}

void LevelTrace::drop()
{
    m_background.cancel();
    m_pixel.reset();
    m_tracedPixel.reset();
    m_contour.reset();
    Q_EMIT changed();
}

void LevelTrace::pointAt(const glm::dvec3& placeLps)
{
    const std::optional<glm::ivec2> pixel = m_slice.lattice().pixelAt(placeLps);
    if (!pixel && m_pixel)
        drop();
    m_pixel = pixel;
    proceed();
}

void LevelTrace::proceed()
{
    if (!m_pixel || isKnown() || !m_slice.pixels() || m_background.busy())
        return;
    const auto trace = [pixels = m_slice.pixels(), pixel = *m_pixel] {
        return core::levelContour(*pixels, pixel);
    };
    m_background.start(
        this, trace, [this, pixel = *m_pixel](core::Result<core::LevelContour> contour) {
            if (!contour) {
                m_workspace.fail(contour.error());
                Q_EMIT failed();
                return;
            }
            m_tracedPixel = pixel;
            m_contour = *std::move(contour);
            proceed();
            Q_EMIT changed();
        });
}

std::vector<glm::dvec3> LevelTrace::contourLps() const
{
    std::vector<glm::dvec3> places;
    if (!m_contour)
        return places;
    places.reserve(m_contour->corners.size());
    for (const glm::ivec2& corner : m_contour->corners)
        places.push_back(m_slice.lattice().cornerLps(corner));
    return places;
}

} // namespace ui
