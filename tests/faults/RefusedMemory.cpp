// SPDX-License-Identifier: Apache-2.0

// Preloaded into the program: one allocation of it, or all from one on, is refused, as a system
// does that has no more memory. By environment variables:
//   BURIN_REFUSE_NTH     which one, counted from 1; 0: none, they are counted only
//   BURIN_REFUSE_LEAST   only those of at least so many bytes count
//   BURIN_REFUSE_OURS    1: only those count that the program's own code asks for by operator new
//   BURIN_REFUSE_LIBRARIES  1: only those count that a library's code asks for by operator new
//   BURIN_REFUSE_ON      1: that one and all that follow
//   BURIN_REFUSE_TELL    1: who asked for it, on stderr
//   BURIN_REFUSE_REPORT  a file that says how many there were, when the program is left orderly

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <execinfo.h>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

long numberFrom(const char* name, long otherwise)
{
    const char* text = std::getenv(name);
    return text ? std::atol(text) : otherwise;
}

std::atomic<bool> ready = false;
long nth = 0;
std::size_t least = 0;
bool onlyOurs = false;
bool onlyLibraries = false;
bool onAndOn = false;
bool tells = false;
std::atomic<long> counted = 0;
const char* newBegin = nullptr; ///< the program's operator new
const void* program = nullptr; ///< where it is loaded
thread_local bool looking = false;

constexpr std::ptrdiff_t longestNew = 256; ///< bytes of its code

enum class Caller { Unknown, Program, Library };

/// Whose code called operator new, if that is what asks.
Caller callerOfNew()
{
    constexpr int deepest = 8;
    void* frames[deepest];
    const int depth = backtrace(frames, deepest);
    bool byNew = false;
    for (int i = 0; i < depth; ++i) {
        const auto* at = static_cast<const char*>(frames[i]);
        if (at >= newBegin && at < newBegin + longestNew) {
            byNew = true;
            continue;
        }
        if (!byNew)
            continue;
        Dl_info info{};
        return dladdr(at, &info) != 0 && info.dli_fbase == program ? Caller::Program
                                                                   : Caller::Library;
    }
    return Caller::Unknown;
}

bool refuses(std::size_t bytes)
{
    if (!ready || bytes < least || looking)
        return false;
    if (onlyOurs || onlyLibraries) {
        looking = true;
        const Caller caller = callerOfNew();
        looking = false;
        if (caller != (onlyOurs ? Caller::Program : Caller::Library))
            return false;
    }
    const long call = ++counted;
    const bool refused = nth > 0 && (call == nth || (onAndOn && call > nth));
    if (refused && tells) {
        looking = true;
        void* frames[24];
        backtrace_symbols_fd(frames, backtrace(frames, 24), 2);
        looking = false;
    }
    return refused;
}

__attribute__((constructor)) void begin()
{
    nth = numberFrom("BURIN_REFUSE_NTH", 0);
    least = std::size_t(numberFrom("BURIN_REFUSE_LEAST", 0));
    onlyOurs = numberFrom("BURIN_REFUSE_OURS", 0) != 0;
    onlyLibraries = numberFrom("BURIN_REFUSE_LIBRARIES", 0) != 0;
    tells = numberFrom("BURIN_REFUSE_TELL", 0) != 0;
    onAndOn = numberFrom("BURIN_REFUSE_ON", 0) != 0;
    void* frame = nullptr;
    backtrace(&frame, 1); // loads what it needs while nothing is refused
    newBegin = static_cast<const char*>(dlsym(RTLD_DEFAULT, "_Znwm"));
    Dl_info info{};
    if (newBegin && dladdr(newBegin, &info) != 0)
        program = info.dli_fbase;
    ready = true;
}

__attribute__((destructor)) void end()
{
    ready = false;
    const char* path = std::getenv("BURIN_REFUSE_REPORT");
    if (!path)
        return;
    if (std::FILE* file = std::fopen(path, "w")) {
        std::fprintf(file, "%ld\n", counted.load());
        std::fclose(file);
    }
}

void* none()
{
    errno = ENOMEM;
    return nullptr;
}

} // namespace

extern "C" {

__attribute__((visibility("default"))) void* malloc(std::size_t bytes)
{
    return refuses(bytes) ? none() : __libc_malloc(bytes);
}

__attribute__((visibility("default"))) void* calloc(std::size_t count, std::size_t bytes)
{
    return refuses(count * bytes) ? none() : __libc_calloc(count, bytes);
}

__attribute__((visibility("default"))) void* realloc(void* place, std::size_t bytes)
{
    return bytes > 0 && refuses(bytes) ? none() : __libc_realloc(place, bytes);
}

__attribute__((visibility("default"))) void* aligned_alloc(std::size_t alignment, std::size_t bytes)
{
    return refuses(bytes) ? none() : __libc_memalign(alignment, bytes);
}

__attribute__((visibility("default"))) int posix_memalign(
    void** place, std::size_t alignment, std::size_t bytes)
{
    void* made = refuses(bytes) ? nullptr : __libc_memalign(alignment, bytes);
    if (!made)
        return ENOMEM;
    *place = made;
    return 0;
}

} // extern "C"
