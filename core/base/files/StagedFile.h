// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/files/FollowedFile.h"

#include <QString>

namespace core {

/// Checks that a file may be written under a name: the name must be free or, with @p
/// replaceExisting, belong to a regular file that this process does not use (FileInUse). Links,
/// pipes and devices are never replaced.
/// @param overSession a session in use is accepted, since the caller knows that it is its own
/// Errors: FileExists, FileUnwritable with the reason.
[[nodiscard]] Result<void> checkFileTarget(
    const QString& target, bool replaceExisting, bool overSession = false);

/// A free hidden name in the folder of @p target, with the same ending.
[[nodiscard]] QString temporaryNameBeside(const QString& target);

/// A file that appears under its name only when it is complete; all files are written through this
/// class.
///
/// It is written under a temporary name in the folder of its target, with the same ending so that
/// readers which depend on the ending can check it, and renamed by commit(). If it is destroyed
/// before commit(), nothing is left, and a file of the target's name is unchanged.
class StagedFile {
public:
    /// Creates the empty temporary file. Errors: those of checkFileTarget().
    static Result<StagedFile> create(
        const QString& target, bool replaceExisting, bool overSession = false);

    /// Takes over an existing file in the folder of its target. It is not removed if it is never
    /// committed.
    static StagedFile adopt(
        const QString& path, const QString& target, bool replaceExisting = true);

    StagedFile(StagedFile&& other) noexcept;
    StagedFile& operator=(StagedFile&& other) noexcept;
    ~StagedFile();

    [[nodiscard]] const QString& path() const { return m_path; } ///< the temporary name
    [[nodiscard]] const QString& target() const { return m_target; }

    /// Writes the content to the disk and gives the file its name; to be called once. A file that
    /// it replaces is kept under the temporary name until this is destroyed. Errors: FileExists (it
    /// was created in the meantime), FileUnwritable.
    Result<void> commit();
    /// Keeps the file under its temporary name.
    void release() { m_path.clear(); }
    [[nodiscard]] bool isCommitted() const { return m_committed; }
    /// After commit(): undoes it, so that a file that was replaced has its name again and the new
    /// one a temporary name, path(). If the disk prevents that, the new file keeps the target's
    /// name, unless it replaced nothing and is no adopted one: then it is removed. What another
    /// program has put in the place of the new one stays there.
    /// @return the name under which the replaced file is then left; empty: everything is as it was
    /// before commit()
    QString takeBack();

private:
    StagedFile() = default;

    [[nodiscard]] bool exchange(const QByteArray& from, const QByteArray& to);

    QString m_path; ///< empty: nothing to remove
    QString m_before; ///< the temporary name that it had before commit()
    QString m_target;
    /// Where exchange() had to leave what had the target's name; empty: nowhere.
    QString m_astray;
    FollowedFile m_made; ///< from commit() on: the new file
    bool m_replaceExisting = false;
    bool m_overSession = false;
    bool m_isAdopted = false; ///< there is no other copy of it
    bool m_committed = false;
};

} // namespace core
