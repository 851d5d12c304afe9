// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/Sanitizer.h"

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#include <cstdarg>

#include <sys/types.h>

extern "C" int __clone(int (*function)(void*), void* stack, int flags, void* argument, ...);

/// QProcess starts a program by a child that shares its parent's memory until then. The sanitizer's
/// own clone() takes it for a copy of the process and stumbles over the state that both then note.
/// Past that, what the child does counts as done by its parent, which waits meanwhile.
extern "C" int clone(int (*function)(void*), void* stack, int flags, void* argument, ...)
{
    va_list more;
    va_start(more, argument);
    auto* parent = va_arg(more, pid_t*);
    void* own = va_arg(more, void*);
    auto* child = va_arg(more, pid_t*);
    va_end(more);
    return __clone(function, stack, flags, argument, parent, own, child);
}
#endif
#endif
