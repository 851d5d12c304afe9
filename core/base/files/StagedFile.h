// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

namespace core {

/// Whether a file may be written under a name: a free one, or with @p replaceExisting that of a
/// plain file that this process does not use (FileInUse). Links, pipes and devices are never
/// replaced.
/// @param overSession it may be a session in use: the caller knows that it is its own
/// Errors: FileExists, FileUnwritable with the reason.
[[nodiscard]] Result<void> checkFileTarget(
    const QString& target, bool replaceExisting, bool overSession = false);

/// A hidden name that is free, in the folder of @p target and with its ending.
[[nodiscard]] QString temporaryNameBeside(const QString& target);

/// The one door for files that are written: one that appears under its name only once it is whole.
///
/// It is written under a temporary name in the folder of its target (same ending, so that readers
/// which go by the ending can check it), and renamed by commit(). Destroyed before commit() it
/// leaves nothing behind, and a file of the target's name is as it was.
class StagedFile {
public:
    /// Makes the empty temporary file. Errors: those of checkFileTarget().
    static Result<StagedFile> create(
        const QString& target, bool replaceExisting, bool overSession = false);

    /// A file that is there already, in the folder of its target, which may be replaced.
    static StagedFile adopt(const QString& path, const QString& target);

    StagedFile(StagedFile&& other) noexcept;
    StagedFile& operator=(StagedFile&& other) noexcept;
    ~StagedFile();

    [[nodiscard]] const QString& path() const { return m_path; } ///< the temporary name
    [[nodiscard]] const QString& target() const { return m_target; }

    /// Brings the content to the disk and gives the file its name; once. The file that it replaces
    /// is kept under the temporary name until this is destroyed.
    /// Errors: FileExists (it came into being meanwhile), FileUnwritable.
    Result<void> commit();
    /// It stays under its temporary name.
    void release() { m_path.clear(); }
    /// After commit(): what there was stands again under the name, or nothing.
    void takeBack();

private:
    StagedFile() = default;

    [[nodiscard]] bool exchange(const QByteArray& from, const QByteArray& to);

    QString m_path; ///< empty: nothing to remove
    QString m_target;
    bool m_replaceExisting = false;
    bool m_overSession = false;
    bool m_committed = false;
};

} // namespace core
