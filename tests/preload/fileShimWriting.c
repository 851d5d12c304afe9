// SPDX-License-Identifier: Apache-2.0
#define _GNU_SOURCE

#include "fileShim.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

// --- Writing ---

ssize_t write(int file, const void* bytes, size_t size)
{
    const ssize_t count = shim_granted(file, size);
    return count < 0 ? -1 : syscall(SYS_write, file, bytes, (size_t)count);
}
ssize_t pwrite(int file, const void* bytes, size_t size, off_t at)
{
    const ssize_t count = shim_granted(file, size);
    return count < 0 ? -1 : syscall(SYS_pwrite64, file, bytes, (size_t)count, at);
}
ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at)
{
    return pwrite(file, bytes, size, at);
}
ssize_t writev(int file, const struct iovec* parts, int count)
{
    const ssize_t whole = shim_granted(file, 2);
    return whole < 0 ? -1 : syscall(SYS_writev, file, parts, whole < 2 && count > 1 ? 1 : count);
}
ssize_t sendfile(int to, int from, off_t* at, size_t size)
{
    const ssize_t count = shim_granted(to, size);
    return count < 0 ? -1 : syscall(SYS_sendfile, to, from, at, (size_t)count);
}
ssize_t sendfile64(int to, int from, off64_t* at, size_t size)
{
    return sendfile(to, from, at, size);
}
ssize_t copy_file_range(
    int from, off64_t* fromAt, int to, off64_t* toAt, size_t size, unsigned flags)
{
    const ssize_t count = shim_granted(to, size);
    return count < 0 ? -1
                     : syscall(SYS_copy_file_range, from, fromAt, to, toAt, (size_t)count, flags);
}
int ftruncate(int file, off_t size)
{
    return shim_granted(file, 1) < 0 ? -1 : (int)syscall(SYS_ftruncate, file, size);
}
int ftruncate64(int file, off64_t size)
{
    return ftruncate(file, size);
}
int fallocate(int file, int mode, off_t at, off_t size)
{
    return shim_granted(file, 1) < 0 ? -1 : (int)syscall(SYS_fallocate, file, mode, at, size);
}
int fallocate64(int file, int mode, off64_t at, off64_t size)
{
    return fallocate(file, mode, at, size);
}
int posix_fallocate(int file, off_t at, off_t size)
{
    if (shim_granted(file, 1) < 0)
        return errno;
    return ((int (*)(int, off_t, off_t))dlsym(RTLD_NEXT, "posix_fallocate"))(file, at, size);
}
int posix_fallocate64(int file, off64_t at, off64_t size)
{
    return posix_fallocate(file, at, size);
}
int truncate(const char* path, off_t size)
{
    char full[pathBytes];
    shim_fullPath(AT_FDCWD, path, full);
    shim_tell("truncate", full, "");
    return (int)syscall(SYS_truncate, path, size);
}
int truncate64(const char* path, off64_t size)
{
    return truncate(path, size);
}

static int synced(int file, long call)
{
    char full[pathBytes];
    if (shim_isFailing("sync")) {
        shim_pathOf(file, full);
        if (shim_isTurn("sync", full) && shim_error != 0)
            return -1;
    }
    return (int)syscall(call, file);
}
int fsync(int file)
{
    return synced(file, SYS_fsync);
}
int fdatasync(int file)
{
    return synced(file, SYS_fdatasync);
}

// --- Names ---

static int renamed(
    const char* what, int from, const char* path, int to, const char* target, unsigned flags)
{
    char old[pathBytes];
    char new[pathBytes];
    shim_fullPath(from, path, old);
    shim_fullPath(to, target, new);
    if (shim_isTurn("rename", shim_isUnder(new) ? new : old) && shim_error != 0)
        return -1;
    const int done = (int)syscall(SYS_renameat2, from, path, to, target, flags);
    if (done == 0)
        shim_tell(flags & RENAME_EXCHANGE ? "exchange" : what, old, new);
    return done;
}
int rename(const char* path, const char* target)
{
    return renamed("rename", AT_FDCWD, path, AT_FDCWD, target, 0);
}
int renameat(int from, const char* path, int to, const char* target)
{
    return renamed("rename", from, path, to, target, 0);
}
int renameat2(int from, const char* path, int to, const char* target, unsigned flags)
{
    return renamed("rename", from, path, to, target, flags);
}

static int linked(int from, const char* path, int to, const char* target, int flags)
{
    char old[pathBytes];
    char new[pathBytes];
    shim_fullPath(from, path, old);
    shim_fullPath(to, target, new);
    if (shim_isTurn("rename", new) && shim_error != 0)
        return -1;
    const int done = (int)syscall(SYS_linkat, from, path, to, target, flags);
    if (done == 0)
        shim_tell("link", old, new);
    return done;
}
int link(const char* path, const char* target)
{
    return linked(AT_FDCWD, path, AT_FDCWD, target, 0);
}
int linkat(int from, const char* path, int to, const char* target, int flags)
{
    return linked(from, path, to, target, flags);
}
int symlinkat(const char* path, int folder, const char* target)
{
    char full[pathBytes];
    const int done = (int)syscall(SYS_symlinkat, path, folder, target);
    shim_fullPath(folder, target, full);
    if (done == 0)
        shim_tell("symlink", full, path);
    return done;
}
int symlink(const char* path, const char* target)
{
    return symlinkat(path, AT_FDCWD, target);
}

static int removed(int folder, const char* path, int flags)
{
    char full[pathBytes];
    const int done = (int)syscall(SYS_unlinkat, folder, path, flags);
    shim_fullPath(folder, path, full);
    if (done == 0)
        shim_tell("remove", full, "");
    return done;
}
int unlink(const char* path)
{
    return removed(AT_FDCWD, path, 0);
}
int unlinkat(int folder, const char* path, int flags)
{
    return removed(folder, path, flags);
}
int rmdir(const char* path)
{
    return removed(AT_FDCWD, path, AT_REMOVEDIR);
}
int remove(const char* path)
{
    const int done = removed(AT_FDCWD, path, 0);
    return done != 0 && errno == EISDIR ? removed(AT_FDCWD, path, AT_REMOVEDIR) : done;
}

int mkdirat(int folder, const char* path, mode_t mode)
{
    char full[pathBytes];
    char more[32];
    const int done = (int)syscall(SYS_mkdirat, folder, path, mode);
    shim_fullPath(folder, path, full);
    snprintf(more, sizeof more, "%o", (unsigned)mode);
    if (done == 0)
        shim_tell("make", full, more);
    return done;
}
int mkdir(const char* path, mode_t mode)
{
    return mkdirat(AT_FDCWD, path, mode);
}
int mknodat(int folder, const char* path, mode_t mode, dev_t device)
{
    char full[pathBytes];
    const int done = (int)syscall(SYS_mknodat, folder, path, mode, device);
    shim_fullPath(folder, path, full);
    if (done == 0)
        shim_tell("node", full, "");
    return done;
}
int mknod(const char* path, mode_t mode, dev_t device)
{
    return mknodat(AT_FDCWD, path, mode, device);
}
