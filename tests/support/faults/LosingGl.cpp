// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/LosingGl.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <atomic>
#include <cassert>
#include <utility>
#include <vector>

namespace test {

namespace {

std::atomic<int> counted = 0;
std::atomic<int> losses = 0;
std::atomic<int> next = 0; ///< at which look; 0: at none
std::atomic<int> gap = 0;
std::atomic<bool> byStatus = false;
std::atomic<bool> living = false;
thread_local bool isLost = false;

/// The driver's own; only in a call that the program makes of it, so that there is a driver.
template <class Function> Function driversOwn(const char* name)
{
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

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

/// The loader's pointers as they were, to be put back. Inside a function: it may live before any
/// global is sure to exist.
std::vector<std::pair<void**, void*>>& replaced()
{
    static std::vector<std::pair<void**, void*>> all;
    return all;
}

template <class Function> void replace(Function& pointer, Function ours)
{
    auto** place = reinterpret_cast<void**>(&pointer);
    replaced().emplace_back(place, *place);
    pointer = ours;
}

template <int Which, class... Arguments>
void leaveUndone(void (*&pointer)(Arguments...), const char* name)
{
    Undone<Which, Arguments...>::name = name;
    replace(pointer, &Undone<Which, Arguments...>::call);
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
    replace(epoxy_glGetError, &losingGetError);
    replace(epoxy_glGetGraphicsResetStatus, &losingResetStatus);
    replace(epoxy_glClientWaitSync, &losingWait);
    replace(epoxy_glMapNamedBufferRange, &losingMap);
    leaveUndone<0>(epoxy_glDispatchCompute, "glDispatchCompute");
    leaveUndone<1>(epoxy_glDispatchComputeIndirect, "glDispatchComputeIndirect");
    leaveUndone<2>(epoxy_glGetNamedBufferSubData, "glGetNamedBufferSubData");
    leaveUndone<3>(epoxy_glNamedBufferSubData, "glNamedBufferSubData");
    leaveUndone<4>(epoxy_glClearNamedBufferSubData, "glClearNamedBufferSubData");
    leaveUndone<5>(epoxy_glGetTextureSubImage, "glGetTextureSubImage");
    leaveUndone<6>(epoxy_glTextureSubImage3D, "glTextureSubImage3D");
    leaveUndone<7>(epoxy_glReadPixels, "glReadPixels");
}

LosingGl::~LosingGl()
{
    for (const auto& [place, pointer] : replaced())
        *place = pointer;
    replaced().clear();
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
