// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/egl.h>

#include <utility>
#include <vector>

namespace test {

/// The driver's own function; only in a call that the program makes of it, so that there is a
/// driver.
template <class Function> Function driversOwn(const char* name)
{
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// Functions of GL that lead to others while it lives: the loader's pointers are put back as they
/// were. It has no place in a global, which may exist too late.
class RedirectedGl {
public:
    RedirectedGl() = default;
    ~RedirectedGl()
    {
        for (const auto& [place, pointer] : m_replaced)
            *place = pointer;
    }
    RedirectedGl(const RedirectedGl&) = delete;
    RedirectedGl& operator=(const RedirectedGl&) = delete;

    /// @param loaders epoxy_gl…
    template <class Function> void lead(Function& loaders, Function ours)
    {
        auto** place = reinterpret_cast<void**>(&loaders);
        m_replaced.emplace_back(place, *place);
        loaders = ours;
    }

private:
    std::vector<std::pair<void**, void*>> m_replaced;
};

} // namespace test
