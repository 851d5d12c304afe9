// SPDX-License-Identifier: Apache-2.0
#define _GNU_SOURCE

#include "fileShim.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

// --- Opening ---

static int opened(int folder, const char* path, int flags, mode_t mode)
{
    char full[pathBytes];
    char more[32];
    struct stat status;
    const int writes = (flags & O_ACCMODE) != O_RDONLY || (flags & (O_CREAT | O_TRUNC)) != 0;
    if (!writes)
        return (int)syscall(SYS_openat, folder, path, flags, mode);
    shim_fullPath(folder, path, full);
    if (shim_isTurn("open", full) && shim_error != 0)
        return -1;
    const int file = (int)syscall(SYS_openat, folder, path, flags, mode);
    if (file >= 0) {
        const int before = errno;
        if (fstat(file, &status) != 0)
            status.st_mode = 0;
        snprintf(more, sizeof more, "%o", (unsigned)(status.st_mode & 07777));
        shim_tell((flags & O_TMPFILE) == O_TMPFILE ? "unnamed" : "open", full, more);
        errno = before;
    }
    return file;
}

static mode_t modeOf(int flags, va_list list)
{
    return (flags & O_CREAT) || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(list, mode_t) : 0;
}

#define OPEN(name)                                                                                 \
    int name(const char* path, int flags, ...)                                                     \
    {                                                                                              \
        va_list list;                                                                              \
        va_start(list, flags);                                                                     \
        const mode_t mode = modeOf(flags, list);                                                   \
        va_end(list);                                                                              \
        return opened(AT_FDCWD, path, flags, mode);                                                \
    }
#define OPEN_AT(name)                                                                              \
    int name(int folder, const char* path, int flags, ...)                                         \
    {                                                                                              \
        va_list list;                                                                              \
        va_start(list, flags);                                                                     \
        const mode_t mode = modeOf(flags, list);                                                   \
        va_end(list);                                                                              \
        return opened(folder, path, flags, mode);                                                  \
    }
OPEN(open)
OPEN(open64)
OPEN_AT(openat)
OPEN_AT(openat64)

// Those that programs compiled with _FORTIFY_SOURCE call.
int __open_2(const char* path, int flags);
int __open64_2(const char* path, int flags);
int __openat_2(int folder, const char* path, int flags);
int __openat64_2(int folder, const char* path, int flags);
int __open_2(const char* path, int flags)
{
    return opened(AT_FDCWD, path, flags, 0);
}
int __open64_2(const char* path, int flags)
{
    return opened(AT_FDCWD, path, flags, 0);
}
int __openat_2(int folder, const char* path, int flags)
{
    return opened(folder, path, flags, 0);
}
int __openat64_2(int folder, const char* path, int flags)
{
    return opened(folder, path, flags, 0);
}

int creat(const char* path, mode_t mode)
{
    return opened(AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, mode);
}
int creat64(const char* path, mode_t mode)
{
    return opened(AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, mode);
}

// --- Streams: libc writes for them by itself, where nobody can stand between ---

static ssize_t cookieRead(void* cookie, char* bytes, size_t size)
{
    return read((int)(long)cookie, bytes, size);
}
static ssize_t cookieWrite(void* cookie, const char* bytes, size_t size)
{
    size_t done = 0;
    while (done < size) {
        const ssize_t count = write((int)(long)cookie, bytes + done, size - done);
        if (count <= 0)
            return done > 0 ? (ssize_t)done : 0;
        done += (size_t)count;
    }
    return (ssize_t)done;
}
static int cookieSeek(void* cookie, off64_t* offset, int whence)
{
    const off64_t at = lseek64((int)(long)cookie, *offset, whence);
    if (at < 0)
        return -1;
    *offset = at;
    return 0;
}
static int cookieClose(void* cookie)
{
    return close((int)(long)cookie);
}

typedef FILE* (*OpenStream)(const char*, const char*);

static FILE* stream(const char* name, const char* path, const char* mode)
{
    static const cookie_io_functions_t calls = {cookieRead, cookieWrite, cookieSeek, cookieClose};
    char full[pathBytes];
    int flags = mode[0] == 'w' ? O_CREAT | O_TRUNC : mode[0] == 'a' ? O_CREAT | O_APPEND : 0;
    const OpenStream real = (OpenStream)dlsym(RTLD_NEXT, name);
    if (mode[0] == 'r' && !strchr(mode, '+'))
        return real(path, mode);
    shim_fullPath(AT_FDCWD, path, full);
    if (!shim_isUnder(full)) {
        FILE* file = real(path, mode);
        if (file)
            shim_tell("open", full, "");
        return file;
    }
    flags |= strchr(mode, '+') ? O_RDWR : O_WRONLY;
    flags |= strchr(mode, 'x') ? O_EXCL : 0;
    const int file = opened(AT_FDCWD, path, flags, 0666);
    return file < 0 ? NULL : fopencookie((void*)(long)file, mode, calls);
}
FILE* fopen(const char* path, const char* mode)
{
    return stream("fopen", path, mode);
}
FILE* fopen64(const char* path, const char* mode)
{
    return stream("fopen64", path, mode);
}
typedef FILE* (*ReopenStream)(const char*, const char*, FILE*);
static FILE* restream(const char* name, const char* path, const char* mode, FILE* file)
{
    char full[pathBytes];
    if (path && !(mode[0] == 'r' && !strchr(mode, '+'))) {
        shim_fullPath(AT_FDCWD, path, full);
        shim_tell("open", full, "");
    }
    return ((ReopenStream)dlsym(RTLD_NEXT, name))(path, mode, file);
}
FILE* freopen(const char* path, const char* mode, FILE* file)
{
    return restream("freopen", path, mode, file);
}
FILE* freopen64(const char* path, const char* mode, FILE* file)
{
    return restream("freopen64", path, mode, file);
}

// --- Temporary files ---

static int told(int file, const char* path)
{
    char full[pathBytes];
    if (file >= 0) {
        shim_fullPath(AT_FDCWD, path, full);
        shim_tell("open", full, "600");
    }
    return file;
}
#define MAKE_TEMPORARY(name, parameters, arguments)                                                \
    int name parameters                                                                            \
    {                                                                                              \
        return told(((int(*) parameters)dlsym(RTLD_NEXT, #name))arguments, path);                  \
    }
MAKE_TEMPORARY(mkstemp, (char* path), (path))
MAKE_TEMPORARY(mkstemp64, (char* path), (path))
MAKE_TEMPORARY(mkostemp, (char* path, int flags), (path, flags))
MAKE_TEMPORARY(mkostemp64, (char* path, int flags), (path, flags))
MAKE_TEMPORARY(mkstemps, (char* path, int suffix), (path, suffix))
MAKE_TEMPORARY(mkstemps64, (char* path, int suffix), (path, suffix))
MAKE_TEMPORARY(mkostemps, (char* path, int suffix, int flags), (path, suffix, flags))
MAKE_TEMPORARY(mkostemps64, (char* path, int suffix, int flags), (path, suffix, flags))
char* mkdtemp(char* path)
{
    char full[pathBytes];
    char* made = ((char* (*)(char*))dlsym(RTLD_NEXT, "mkdtemp"))(path);
    if (made) {
        shim_fullPath(AT_FDCWD, made, full);
        shim_tell("make", full, "700");
    }
    return made;
}
