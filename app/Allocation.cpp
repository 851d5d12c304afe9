// SPDX-License-Identifier: Apache-2.0
#include "app/end/CallerOfNew.h"
#include "app/end/SuddenEnd.h"
#include "core/base/MemoryReserve.h"
#include "gpu/gl/context/CallsDriver.h"

#include <cstdlib>
#include <new>

// The program's own operator new (of main()'s object files only: tests bring others): as the
// library's, but what is refused says how much it was, and nothing is thrown into the graphics
// driver. Its other forms lead here.

void* operator new(std::size_t bytes)
{
    if (void* place = std::malloc(bytes > 0 ? bytes : 1))
        return place;
    core::giveUpMemoryReserve();
    if (gpu::CallsDriver::onThisThread() && app::isLibraryCode(__builtin_return_address(0))) {
        // The reserve may be enough for what it is doing.
        if (void* place = std::malloc(bytes > 0 ? bytes : 1))
            return place;
        app::endForWantOfMemory();
    }
    throw core::MemoryRefused(bytes);
}

void operator delete(void* place) noexcept
{
    std::free(place);
}

void operator delete(void* place, std::size_t) noexcept
{
    std::free(place);
}
