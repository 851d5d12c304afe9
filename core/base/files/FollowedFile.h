// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// A file that is recognised after another program has renamed, moved, deleted or replaced it. It
/// is not opened for reading or writing, so that locks which this process holds on it stay: closing
/// any other descriptor of a file drops them (POSIX, fcntl).
class FollowedFile {
public:
    FollowedFile() = default; ///< follows no file; isAt() is then true of every path
    /// Follows the file to which @p path leads; none if there is none, or no descriptor is free.
    explicit FollowedFile(const QString& path);
    FollowedFile(FollowedFile&& other) noexcept;
    FollowedFile& operator=(FollowedFile&& other) noexcept;
    ~FollowedFile();

    /// Whether @p path leads to the file. A path that cannot be checked at the moment counts as
    /// leading to it. Cost: one file system call.
    [[nodiscard]] bool isAt(const QString& path) const;
    /// Whether there is a file that is followed.
    [[nodiscard]] bool isValid() const { return m_descriptor >= 0; }
    /// The path that leads to it now; empty: it was deleted, or is in the trash.
    [[nodiscard]] QString path() const;

private:
    int m_descriptor = -1;
};

} // namespace core
