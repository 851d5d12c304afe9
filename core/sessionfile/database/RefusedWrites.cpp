// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/database/RefusedWrites.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <mutex>

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
void replaceCalls(sqlite3_vfs& files)
{
    const auto replace = [&files](const char* name, auto* call) {
        files.xSetSystemCall(&files, name, reinterpret_cast<sqlite3_syscall_ptr>(call));
    };
    replace("open", &openNoted);
    replace("write", &writeNoted);
    replace("pwrite", &writeAtNoted);
    replace("pwrite64", &writeAtNoted);
    replace("ftruncate", &resizeNoted);
}

/// The newest form of these interfaces that is known here: a newer SQLite has more behind it.
constexpr int knownForm = 3;

/// What SQLite does with a file, but for bringing it to the disk: that is no call that may be
/// replaced. SQLite keeps errno with the file, and a journal or a copy is closed before anybody
/// could ask for it.
struct NotedMethods : sqlite3_io_methods {
    const sqlite3_io_methods* real;
};

int syncNoted(sqlite3_file* file, int flags)
{
    const sqlite3_io_methods& real = *static_cast<const NotedMethods*>(file->pMethods)->real;
    const int answer = real.xSync(file, flags);
    int error = 0;
    if (answer != SQLITE_OK && real.xFileControl(file, SQLITE_FCNTL_LAST_ERRNO, &error) == SQLITE_OK
        && error != 0)
        refusedWith = error;
    return answer;
}

/// SQLite has one set of methods for each way of locking a file. @return null: there is no place
/// for another one
const NotedMethods* notedFor(const sqlite3_io_methods* real)
{
    static std::mutex mutex;
    static std::array<NotedMethods, 8> all{};
    const std::lock_guard lock(mutex);
    for (NotedMethods& each : all) {
        if (each.real == real)
            return &each;
        if (each.real)
            continue;
        static_cast<sqlite3_io_methods&>(each) = *real;
        each.iVersion = std::min(real->iVersion, knownForm);
        each.xSync = &syncNoted;
        each.real = real;
        return &each;
    }
    return nullptr;
}

sqlite3_vfs* systemFiles = nullptr;

int openFileNoted(
    sqlite3_vfs* files, const char* name, sqlite3_file* file, int flags, int* flagsBack)
{
    const int answer = systemFiles->xOpen(files, name, file, flags, flagsBack);
    if (answer != SQLITE_OK || !file->pMethods)
        return answer;
    if (const NotedMethods* methods = notedFor(file->pMethods))
        file->pMethods = methods;
    return answer;
}

/// A journal that cannot be removed is not committed.
int removeNoted(sqlite3_vfs* files, const char* name, int syncsFolder)
{
    const int answer = systemFiles->xDelete(files, name, syncsFolder);
    if (answer != SQLITE_OK && answer != SQLITE_IOERR_DELETE_NOENT)
        refusedWith = errno;
    return answer;
}

/// SQLite's own way to files, with what is noted. All that is opened from now on goes by it.
bool noteAll()
{
    static sqlite3_vfs ours;
    sqlite3_vfs* const files = sqlite3_vfs_find(nullptr);
    if (!files || files->iVersion < 3 || !files->xSetSystemCall)
        return false;
    replaceCalls(*files);
    systemFiles = files;
    ours = *files;
    ours.iVersion = std::min(files->iVersion, knownForm);
    ours.pNext = nullptr;
    ours.zName = "burin";
    ours.xOpen = &openFileNoted;
    ours.xDelete = &removeNoted;
    return sqlite3_vfs_register(&ours, 1) == SQLITE_OK;
}

} // namespace

void noteRefusedWrites()
{
    // Before the first file is opened: SQLite reads the calls without a lock.
    [[maybe_unused]] static const bool areNoted = noteAll();
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
