// SPDX-License-Identifier: Apache-2.0
#include "app/end/CallerOfNew.h"

#include <algorithm>
#include <array>

#include <dlfcn.h>
#include <execinfo.h>

namespace app {

namespace {

const void* program = nullptr; ///< where it is loaded
const void* standardLibrary = nullptr;

const void* objectOf(const void* code) noexcept
{
    Dl_info info{};
    return ::dladdr(code, &info) != 0 ? info.dli_fbase : nullptr;
}

} // namespace

void prepareToNameCallers() noexcept
{
    void* frame = nullptr;
    ::backtrace(&frame, 1); // loads the unwinder
    program = objectOf(reinterpret_cast<const void*>(&prepareToNameCallers));
    standardLibrary = objectOf(::dlsym(RTLD_DEFAULT, "_ZSt9terminatev"));
}

bool isLibraryCode(const void* caller) noexcept
{
    std::array<void*, 64> frames{};
    const int depth = ::backtrace(frames.data(), int(frames.size()));
    const auto end = frames.begin() + depth;
    for (auto frame = std::find(frames.begin(), end, caller); frame != end; ++frame) {
        const void* object = objectOf(*frame);
        if (object == standardLibrary && object != program)
            continue;
        return object != program;
    }
    return false;
}

} // namespace app
