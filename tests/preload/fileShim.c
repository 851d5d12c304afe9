// SPDX-License-Identifier: Apache-2.0
#define _GNU_SOURCE

#include "fileShim.h"

#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

static const char* logFile;
static const char* under;
static const char* failing;
static long firstFailing;
static long lastFailing;
int shim_error; // 0: short
static atomic_long counted;

/// glibc gives constructors what main() gets.
__attribute__((constructor)) static void readOrders(int count, char** words)
{
    const char* of = getenv("BURIN_SHIM_OF");
    const char* number = getenv("BURIN_SHIM_NTH");
    const char* last = getenv("BURIN_SHIM_LAST");
    const char* error = getenv("BURIN_SHIM_ERROR");
    logFile = getenv("BURIN_SHIM_LOG");
    under = getenv("BURIN_SHIM_UNDER");
    if (!of || (count > 1 && strcmp(words[1], of) == 0))
        failing = getenv("BURIN_SHIM_FAIL");
    firstFailing = number ? atol(number) : 0;
    lastFailing = last ? atol(last) : firstFailing;
    shim_error = error && strcmp(error, "short") != 0 ? atoi(error) : 0;
}

// --- Telling ---

/// Opened anew for each line: a descriptor that is kept might be closed and be another file's then.
void shim_tell(const char* what, const char* path, const char* more)
{
    char line[2 * pathBytes];
    const int before = errno;
    if (!logFile)
        return;
    const int size = snprintf(line, sizeof line, "%s\t%s\t%s\n", what, path, more ? more : "");
    const long file =
        syscall(SYS_openat, AT_FDCWD, logFile, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (file >= 0) {
        syscall(SYS_write, file, line, (size_t)size);
        syscall(SYS_close, file);
    }
    errno = before;
}

/// The path from the root, as far as names alone can tell it.
void shim_fullPath(int folder, const char* path, char* full)
{
    char link[64];
    ssize_t size = 0;
    full[0] = 0;
    if (!path)
        return;
    if (path[0] != '/') {
        if (folder == AT_FDCWD)
            snprintf(link, sizeof link, "/proc/self/cwd");
        else
            snprintf(link, sizeof link, "/proc/self/fd/%d", folder);
        size = syscall(SYS_readlinkat, AT_FDCWD, link, full, (size_t)PATH_MAX - 1);
        if (size < 0)
            size = 0;
        full[size++] = '/';
    }
    snprintf(full + size, (size_t)(pathBytes - size), "%s", path);
}

void shim_pathOf(int file, char* full)
{
    char link[64];
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const ssize_t size = syscall(SYS_readlinkat, AT_FDCWD, link, full, (size_t)PATH_MAX - 1);
    full[size < 0 ? 0 : size] = 0;
}

// --- Failing ---

int shim_isUnder(const char* full)
{
    const size_t size = under ? strlen(under) : 0;
    return size > 0 && strncmp(full, under, size) == 0 && (full[size] == '/' || full[size] == 0);
}

int shim_isFailing(const char* kind)
{
    const size_t size = strlen(kind);
    const char* at = failing;
    while (at && *at) {
        if (strncmp(at, kind, size) == 0 && (at[size] == ',' || at[size] == 0))
            return 1;
        at = strchr(at, ',');
        if (at)
            ++at;
    }
    return 0;
}

/// Whether a call is to fail now.
int shim_isTurn(const char* kind, const char* full)
{
    const int before = errno;
    if (!shim_isFailing(kind) || !shim_isUnder(full))
        return 0;
    const long turn = 1 + atomic_fetch_add(&counted, 1);
    if (firstFailing == 0)
        shim_tell("counts", full, kind);
    if (firstFailing == 0 || turn < firstFailing || turn > lastFailing) {
        errno = before;
        return 0;
    }
    shim_tell("fails", full, kind);
    errno = shim_error;
    return 1;
}

/// @return how much of @p size is to be written; -1: nothing, errno says why
ssize_t shim_granted(int file, size_t size)
{
    char full[pathBytes];
    if (!shim_isFailing("write"))
        return (ssize_t)size;
    shim_pathOf(file, full);
    if (!shim_isTurn("write", full))
        return (ssize_t)size;
    if (shim_error != 0)
        return -1;
    return (ssize_t)(size > 1 ? size / 2 : size);
}
