// SPDX-License-Identifier: Apache-2.0
#include "core/base/MemoryReserve.h"

#include <cstdlib>
#include <new>

// The program's own operator new (of main()'s object files only: tests bring others): as the
// library's, but what is refused says how much it was. Its other forms lead here.

void* operator new(std::size_t bytes)
{
    if (void* place = std::malloc(bytes > 0 ? bytes : 1))
        return place;
    core::giveUpMemoryReserve();
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
