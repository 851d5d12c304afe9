// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/database/RefusedWrites.h"

#include <cerrno>

#include <fcntl.h>
#include <sqlite3.h>
#include <unistd.h>

namespace core {

namespace {

thread_local int refusedWith = 0;

/// @param answer of a call: less than 0: it failed
template <class Answer> Answer noted(Answer answer)
{
    // SQLite asks again what a signal interrupted.
    if (answer < 0 && errno != EINTR)
        refusedWith = errno;
    return answer;
}

int openNoted(const char* path, int flags, int mode)
{
    // SQLite opens for reading what it cannot open for writing; that is another question.
    const int file = ::open(path, flags, mode);
    return (flags & O_ACCMODE) == O_RDONLY ? file : noted(file);
}

ssize_t writeNoted(int file, const void* bytes, size_t size)
{
    return noted(::write(file, bytes, size));
}

ssize_t writeAtNoted(int file, const void* bytes, size_t size, off64_t at)
{
    return noted(::pwrite64(file, bytes, size, at));
}

int resizeNoted(int file, off64_t size)
{
    return noted(::ftruncate64(file, size));
}

/// https://www.sqlite.org/c3ref/vfs.html: the calls of the system that SQLite makes may be
/// replaced. Which of those for writing it uses was decided when it was compiled.
bool replaceCalls()
{
    sqlite3_vfs* const files = sqlite3_vfs_find(nullptr);
    if (!files || files->iVersion < 3 || !files->xSetSystemCall)
        return false;
    const auto replace = [files](const char* name, auto* call) {
        files->xSetSystemCall(files, name, reinterpret_cast<sqlite3_syscall_ptr>(call));
    };
    replace("open", &openNoted);
    replace("write", &writeNoted);
    replace("pwrite", &writeAtNoted);
    replace("pwrite64", &writeAtNoted);
    replace("ftruncate", &resizeNoted);
    return true;
}

} // namespace

void noteRefusedWrites()
{
    // Before the first file is opened: SQLite reads the calls without a lock.
    [[maybe_unused]] static const bool replaced = replaceCalls();
}

void forgetRefusedWrites()
{
    refusedWith = 0;
}

int lastRefusedWrite()
{
    return refusedWith;
}

} // namespace core
