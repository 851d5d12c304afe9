// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/TimerQuery.h"

namespace gpu {

TimerQuery::TimerQuery(const char* label)
{
    GLuint id = 0;
    glCreateQueries(GL_TIME_ELAPSED, 1, &id);
    m_id = GlId<glDelete::query>(id);
    labelObject(GL_QUERY, id, label);
}

void TimerQuery::begin()
{
    glBeginQuery(GL_TIME_ELAPSED, m_id.get());
}

void TimerQuery::end()
{
    glEndQuery(GL_TIME_ELAPSED);
}

std::optional<double> TimerQuery::milliseconds() const
{
    GLint available = 0;
    glGetQueryObjectiv(m_id.get(), GL_QUERY_RESULT_AVAILABLE, &available);
    if (available == 0)
        return std::nullopt;
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(m_id.get(), GL_QUERY_RESULT, &nanoseconds);
    return double(nanoseconds) * 1e-6;
}

} // namespace gpu
