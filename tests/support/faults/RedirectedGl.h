// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/egl.h>

#include <utility>
#include <vector>

namespace test {

/// Returns the driver's own function. Call it only inside a GL call of the program, since a driver
/// must be loaded.
template <class Function> Function driversOwn(const char* name)
{
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// Redirects GL functions to others during its lifetime; the destructor restores the loader's
/// pointers. Do not make it a global object, which may be created after the first use.
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

    /// Redirects a function. @p loaders is the loader's pointer, epoxy_gl…
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
