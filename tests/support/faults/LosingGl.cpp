// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/LosingGl.h"

#include <epoxy/gl.h>

#include <atomic>
#include <cassert>

namespace test {

namespace {

std::atomic<int> counted = 0;
std::atomic<int> losses = 0;
std::atomic<int> next = 0; ///< at which look; 0: at none
std::atomic<int> gap = 0;
std::atomic<bool> byStatus = false;
std::atomic<bool> living = false;
thread_local bool isLost = false;

GLenum losingGetError()
{
    static const auto own = driversOwn<GLenum (*)()>("glGetError");
    if (!isLost) {
        const int look = ++counted;
        int expected = look;
        isLost = next.compare_exchange_strong(expected, gap > 0 ? look + gap : 0);
        losses += isLost ? 1 : 0;
    }
    return isLost && !byStatus ? GL_CONTEXT_LOST : own();
}

GLenum losingResetStatus()
{
    static const auto own = driversOwn<GLenum (*)()>("glGetGraphicsResetStatus");
    return isLost ? GL_UNKNOWN_CONTEXT_RESET : own();
}

/// What a lost context leaves undone.
template <int Which, class... Arguments> struct Undone {
    static inline const char* name = nullptr;
    static void call(Arguments... arguments)
    {
        static const auto own = driversOwn<void (*)(Arguments...)>(name);
        if (!isLost)
            own(arguments...);
    }
};

GLenum losingWait(GLsync sync, GLbitfield flags, GLuint64 nanoseconds)
{
    static const auto own =
        driversOwn<GLenum (*)(GLsync, GLbitfield, GLuint64)>("glClientWaitSync");
    return isLost ? GL_WAIT_FAILED : own(sync, flags, nanoseconds);
}

void* losingMap(GLuint buffer, GLintptr offset, GLsizeiptr length, GLbitfield access)
{
    static const auto own =
        driversOwn<void* (*)(GLuint, GLintptr, GLsizeiptr, GLbitfield)>("glMapNamedBufferRange");
    return isLost ? nullptr : own(buffer, offset, length, access);
}

template <int Which, class... Arguments>
void leaveUndone(RedirectedGl& gl, void (*&pointer)(Arguments...), const char* name)
{
    Undone<Which, Arguments...>::name = name;
    gl.lead(pointer, &Undone<Which, Arguments...>::call);
}

} // namespace

LosingGl::LosingGl(int first, int every, Tells tells)
{
    assert(!living);
    living = true;
    counted = 0;
    losses = 0;
    next = first;
    gap = every;
    byStatus = tells == Tells::ByStatus;
    m_gl.lead(epoxy_glGetError, &losingGetError);
    m_gl.lead(epoxy_glGetGraphicsResetStatus, &losingResetStatus);
    m_gl.lead(epoxy_glClientWaitSync, &losingWait);
    m_gl.lead(epoxy_glMapNamedBufferRange, &losingMap);
    leaveUndone<0>(m_gl, epoxy_glDispatchCompute, "glDispatchCompute");
    leaveUndone<1>(m_gl, epoxy_glDispatchComputeIndirect, "glDispatchComputeIndirect");
    leaveUndone<2>(m_gl, epoxy_glGetNamedBufferSubData, "glGetNamedBufferSubData");
    leaveUndone<3>(m_gl, epoxy_glNamedBufferSubData, "glNamedBufferSubData");
    leaveUndone<4>(m_gl, epoxy_glClearNamedBufferSubData, "glClearNamedBufferSubData");
    leaveUndone<5>(m_gl, epoxy_glGetTextureSubImage, "glGetTextureSubImage");
    leaveUndone<6>(m_gl, epoxy_glTextureSubImage3D, "glTextureSubImage3D");
    leaveUndone<7>(m_gl, epoxy_glReadPixels, "glReadPixels");
}

LosingGl::~LosingGl()
{
    living = false;
}

int LosingGl::looks() const
{
    return counted;
}

int LosingGl::lost() const
{
    return losses;
}

} // namespace test
