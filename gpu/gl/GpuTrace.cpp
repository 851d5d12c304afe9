// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/GpuTrace.h"

#include "gpu/gl/SoftwareDriver.h"

#include <algorithm>
#include <string>

namespace gpu {

namespace {

std::chrono::nanoseconds sinceEpoch(core::Trace::Clock::time_point time)
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch());
}

} // namespace

GpuTrace::GpuTrace()
{
    if (!core::Trace::isOn() || s_here)
        return;
    GLint bits = 0;
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    if (bits == 0 || !name)
        return;
    const std::string renderer = name;
    m_lane.emplace("GPU: " + renderer);
    // A software driver stamps where it rasterises, which it puts off: after kernels that it
    // computes at once. So it is told to rasterise first.
    m_flushes = isSoftwareDriver();
    GLint64 now = 0;
    glGetInteger64v(GL_TIMESTAMP, &now);
    m_toClock = sinceEpoch(core::Trace::Clock::now()) - std::chrono::nanoseconds(now);
    s_here = this;
}

GpuTrace::~GpuTrace()
{
    if (s_here != this)
        return;
    s_here = nullptr;
    glFinish();
    takeArrived();
}

GpuTrace::Query GpuTrace::stamp()
{
    Query query;
    if (m_free.empty()) {
        GLuint id = 0;
        glCreateQueries(GL_TIMESTAMP, 1, &id);
        query = Query(id);
    } else {
        query = std::move(m_free.back());
        m_free.pop_back();
    }
    glQueryCounter(query.get(), GL_TIMESTAMP);
    if (m_flushes)
        glFlush();
    return query;
}

void GpuTrace::begin()
{
    takeArrived();
    if (m_underWay.size() < mostUnderWay)
        m_open.emplace(Measured{.label = m_used, .begin = stamp(), .end = {}});
}

void GpuTrace::end()
{
    if (!m_open)
        return;
    m_open->end = stamp();
    m_underWay.push_back(*std::exchange(m_open, std::nullopt));
}

void GpuTrace::takeArrived()
{
    while (!m_underWay.empty()) {
        Measured& first = m_underWay.front();
        GLint hasArrived = 0;
        glGetQueryObjectiv(first.end.get(), GL_QUERY_RESULT_AVAILABLE, &hasArrived);
        if (hasArrived == 0)
            return;
        // A processor may begin one before the last is done; on the lane they follow one another.
        const auto begin = std::max(timeOf(first.begin), m_last);
        m_last = std::max(timeOf(first.end), begin);
        core::Trace::add({.category = "gpu",
            .name = core::TraceName::lasting(first.label),
            .lane = m_lane->id(),
            .begin = begin,
            .end = m_last});
        m_free.push_back(std::move(first.begin));
        m_free.push_back(std::move(first.end));
        m_underWay.pop_front();
    }
}

core::Trace::Clock::time_point GpuTrace::timeOf(const Query& query) const
{
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query.get(), GL_QUERY_RESULT, &nanoseconds);
    return core::Trace::Clock::time_point(
        std::chrono::nanoseconds(GLint64(nanoseconds)) + m_toClock);
}

} // namespace gpu
