// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/Fence.h"

#include <utility>

namespace gpu {

Fence Fence::insert()
{
    Fence fence;
    fence.m_sync = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    return fence;
}

Fence::Fence(Fence&& other) noexcept
    : m_sync(std::exchange(other.m_sync, nullptr))
{
}

Fence& Fence::operator=(Fence&& other) noexcept
{
    std::swap(m_sync, other.m_sync);
    return *this;
}

Fence::~Fence()
{
    if (m_sync != nullptr)
        glDeleteSync(m_sync);
}

bool Fence::passed() const
{
    if (m_sync == nullptr)
        return true;
    const GLenum status = glClientWaitSync(m_sync, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    // Where waiting fails, as it does in a lost context, nobody is to wait for ever.
    return status != GL_TIMEOUT_EXPIRED;
}

void Fence::wait() const
{
    constexpr GLuint64 second = 1'000'000'000;
    while (m_sync != nullptr
        && glClientWaitSync(m_sync, GL_SYNC_FLUSH_COMMANDS_BIT, second) == GL_TIMEOUT_EXPIRED) { }
}

} // namespace gpu
