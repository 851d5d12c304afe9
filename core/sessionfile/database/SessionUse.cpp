// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/database/SessionUse.h"

#include "core/base/files/FollowedFile.h"
#include "core/base/files/StagedFile.h"
#include "core/base/files/SystemFile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace core {

namespace {

// Held while a session file is open as a plain file.
std::mutex plainFiles;
/// By keyOf(); under plainFiles.
std::map<QString, std::optional<FileIdentity>> used;

/// The database itself, and what SQLite may leave beside it.
constexpr std::array<const char*, 3> parts{"", "-wal", "-journal"};

QString keyOf(const QString& path)
{
    const QFileInfo info(path);
    const QString canonical = info.canonicalFilePath();
    return canonical.isEmpty() ? info.absoluteFilePath() : canonical;
}

/// Whether this process uses the file, under whatever name; or one that had this name, whose log
/// may still lie there.
/// @pre plainFiles is held
bool isUsed(const QString& path)
{
    if (used.empty())
        return false;
    if (used.count(keyOf(path)) != 0)
        return true;
    const std::optional<FileIdentity> file = FileIdentity::of(path);
    return file && std::any_of(used.begin(), used.end(), [&file](const auto& use) {
        return use.second == file;
    });
}

QString part(const QString& path, const char* suffix)
{
    return path + QLatin1String(suffix);
}

/// @pre plainFiles is held and this process does not use the file
bool isLocked(const QString& path)
{
    // https://www.sqlite.org/src/file/src/os.h: the bytes that SQLite locks, whole file size.
    constexpr off_t firstByte = 0x40000000;
    constexpr off_t bytes = 512;
    const int descriptor = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    struct flock lock { };
    lock.l_type = F_RDLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = firstByte;
    lock.l_len = bytes;
    const bool locked = ::fcntl(descriptor, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
    ::close(descriptor);
    return locked;
}

/// Sizes and times of all parts: whatever is written changes them.
std::array<std::array<std::int64_t, 3>, parts.size()> look(const QString& path)
{
    std::array<std::array<std::int64_t, 3>, parts.size()> all{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        struct stat status { };
        if (::stat(QFile::encodeName(part(path, parts[i])).constData(), &status) == 0)
            all[i] = {status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
    }
    return all;
}

/// What leftLogName() names; there may be gaps, as people put them away.
QStringList leftLogsOf(const QString& path)
{
    constexpr int mostTold = 9;
    const QString place = keyOf(path);
    QStringList all;
    for (int i = 1; i <= mostTold; ++i) {
        if (const QString left = leftLogName(place, i); QFileInfo::exists(left))
            all += left;
    }
    return all;
}

/// Those of any session in the folder of @p path.
QStringList leftLogsAround(const QString& path)
{
    const QDir folder = QFileInfo(keyOf(path)).absoluteDir();
    QStringList all;
    for (const QString& name : folder.entryList(QDir::Files, QDir::Name)) {
        if (name.contains(QLatin1String("-wal.left")))
            all += folder.filePath(name);
    }
    return all;
}

QString named(const QStringList& paths)
{
    return paths.join(QStringLiteral("', '"));
}

/// @param path of a session whose last writes are not beside it
Clause leftOpenReason(const QString& path)
{
    const QString file = QFileInfo(path).fileName();
    const QString wal = part(file, "-wal");
    const QStringList left = leftLogsAround(path);
    if (left.isEmpty())
        return Clause::saying("it was not closed, and '%1', which may hold what was written last, "
                              "is not beside it",
            wal);
    return Clause::saying("it was not closed, and '%1', which may hold what was written last, is "
                          "not beside it; it may be '%2', of which Burin reads a copy that lies "
                          "beside a copy of '%3' and is named '%1'",
        wal, named(left), file);
}

Clause leftBesideReason(const QStringList& left)
{
    return Clause::saying("'%1' holds the last steps of another session, which had this name "
                          "before; nothing reads it there, and nothing is lost by keeping it; "
                          "Burin reads a copy of it that lies beside a copy of that session's own "
                          "file and has its name with '-wal' behind it",
        named(left));
}

Result<void> copyParts(const QString& from, const QString& to)
{
    for (const char* suffix : parts) {
        const QString source = part(from, suffix);
        const QString target = part(to, suffix);
        QFile::remove(target);
        if (!QFileInfo::exists(source))
            continue;
        QFile file(source);
        if (!file.open(QIODevice::ReadOnly))
            return failure(ErrorCode::FileUnreadable, source, file.errorString());
        file.close();
        if (!file.copy(target))
            return failure(ErrorCode::FileUnwritable, target, file.errorString());
        QFile::setPermissions(target, QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    }
    return {};
}

} // namespace

Result<SessionUse> SessionUse::begin(const QString& path)
{
    SessionUse use;
    const std::lock_guard lock(plainFiles);
    if (isUsed(path))
        return failure(
            ErrorCode::FileUnreadable, path, Clause::saying("it is open already, in this window"));
    const QString key = keyOf(path);
    used.emplace(key, FileIdentity::of(path));
    use.m_key = key;
    use.m_file = FileInUse({path}, FileInUse::As::Session);
    return use;
}

bool isSessionFile(const QString& path)
{
    const std::lock_guard lock(plainFiles);
    if (isUsed(path))
        return true;
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return false;
    // https://www.sqlite.org/fileformat.html, 1.3: the application's number at byte 68.
    const QByteArray head = file.read(72);
    return head.startsWith("SQLite format 3") && head.mid(68, 4) == "Burn";
}

Result<void> checkOnlySessionAt(const QString& target)
{
    if (const Result<void> file = checkFileTarget(target, true, true); !file)
        return file;
    if (QFileInfo::exists(target) && !isSessionFile(target))
        return failure(ErrorCode::FileUnwritable, target,
            Clause::saying("it is no session, and nothing else is replaced by one"));
    return {};
}

Result<void> checkReplacedSession(const QString& path)
{
    if (const Result<void> target = checkFileTarget(path, true); !target)
        return target;
    if (!QFileInfo::exists(path))
        return {};
    if (isSessionInUse(path))
        return failure(
            ErrorCode::FileUnwritable, path, Clause::saying("it is open in another window"));
    if (const Result<void> only = checkOnlySessionAt(path); !only)
        return only;
    if (isSessionUnfinished(path))
        return failure(ErrorCode::FileUnwritable, path,
            Clause::saying("it was not closed properly; open it once, or take another name"));
    return {};
}

QString strayPartOf(const QString& path)
{
    for (const char* suffix : {"-wal", "-shm", "-journal"}) {
        const QFileInfo info(part(path, suffix));
        if (info.exists() || info.isSymLink())
            return info.fileName();
    }
    return {};
}

SessionUse::SessionUse(SessionUse&& other) noexcept
    : m_key(std::exchange(other.m_key, QString()))
    , m_file(std::move(other.m_file))
{
}

SessionUse& SessionUse::operator=(SessionUse&& other) noexcept
{
    std::swap(m_key, other.m_key);
    std::swap(m_file, other.m_file);
    return *this;
}

SessionUse::~SessionUse()
{
    if (m_key.isEmpty())
        return;
    const std::lock_guard lock(plainFiles);
    used.erase(m_key);
}

bool isSessionInUse(const QString& path)
{
    const std::lock_guard lock(plainFiles);
    return isUsed(path) || isLocked(path);
}

bool isSessionUnfinished(const QString& path)
{
    return QFileInfo(part(path, "-wal")).size() > 0 || QFileInfo(part(path, "-journal")).size() > 0;
}

SessionLoss sessionLoss(const QString& path)
{
    // https://www.sqlite.org/fileformat.html, 1.3: the database header.
    constexpr qsizetype headBytes = 100;
    static const QByteArray magic("SQLite format 3", 16);
    if (path.isEmpty())
        return {};
    SessionLoss loss;
    if (const QStringList left = leftLogsOf(path); !left.isEmpty())
        loss.leftBeside = leftBesideReason(left);
    // With what lies beside it, it may be whole.
    if (isSessionUnfinished(path))
        return loss;
    const std::lock_guard lock(plainFiles);
    if (isUsed(path))
        return loss;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return loss;
    const QByteArray head = file.read(headBytes);
    if (head.isEmpty() || !magic.startsWith(head.left(magic.size())))
        return loss;
    if (head.size() < headBytes) {
        loss.cutOff = Clause::saying("the file is cut off: only %1 bytes are there", head.size());
        return loss;
    }
    const auto number = [&head](int at, int bytes) {
        qint64 value = 0;
        for (int i = 0; i < bytes; ++i)
            value = 256 * value + std::uint8_t(head[at + i]);
        return value;
    };
    const qint64 pageBytes = number(16, 2) == 1 ? 65536 : number(16, 2);
    const qint64 whole = pageBytes * number(28, 4);
    // The count of pages is kept by whoever changes the counter.
    if (number(24, 4) == number(92, 4) && file.size() < whole)
        loss.cutOff =
            Clause::saying("the file is cut off: %1 of %2 bytes are there", file.size(), whole);
    const bool leftInWal = number(18, 1) == 2;
    if (leftInWal && !QFileInfo::exists(part(path, "-wal")))
        loss.leftOpen = leftOpenReason(path);
    // What lies there may be its own.
    if (!loss.leftOpen.isEmpty())
        loss.leftBeside = {};
    return loss;
}

QString leftLogName(const QString& path, int number)
{
    return path + QLatin1String("-wal.left") + (number == 1 ? QString() : QString::number(number));
}

void removeSessionParts(const QString& path)
{
    for (const char* suffix : {"-wal", "-shm", "-journal"})
        QFile::remove(part(path, suffix));
}

void removeSessionPart(const FollowedFile& followed)
{
    if (const QString now = followed.path(); !now.isEmpty())
        QFile::remove(now);
}

bool moveSessionPart(const FollowedFile& followed, const QString& to)
{
    const QString now = followed.path();
    if (now.isEmpty() || now == to)
        return !now.isEmpty();
    return renameToFreeName(now, to);
}

bool removeSession(const QString& path)
{
    removeSessionParts(path);
    return !QFileInfo::exists(path) || QFile::remove(path);
}

Result<void> copySession(const QString& from, const QString& to)
{
    constexpr int attempts = 20;
    const std::lock_guard lock(plainFiles);
    if (isUsed(from))
        return failure(
            ErrorCode::FileUnreadable, from, Clause::saying("it is open already, in this window"));
    for (int i = 0; i < attempts; ++i) {
        const auto before = look(from);
        if (const Result<void> copied = copyParts(from, to); !copied)
            return copied;
        if (look(from) == before)
            return {};
    }
    return failure(
        ErrorCode::FileUnreadable, from, Clause::saying("another program writes it without pause"));
}

} // namespace core
