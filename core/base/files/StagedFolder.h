// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

namespace core {

/// A folder that appears under its name only when it is complete; all folders are written through
/// this class, as files are through StagedFile.
///
/// It is filled under a hidden name beside its target and renamed by commit(). If it is destroyed
/// before that, nothing is left. It replaces nothing but an empty folder, unless that is asked for.
class StagedFolder {
public:
    /// Creates the empty folder. Errors: FileExists, FileUnwritable.
    static Result<StagedFolder> create(const QString& target);
    /// Takes over a filled folder on the file system of its target.
    static StagedFolder adopt(
        const QString& path, const QString& target, bool replaceExisting = false);

    StagedFolder(StagedFolder&& other) noexcept;
    StagedFolder& operator=(StagedFolder&& other) noexcept;
    ~StagedFolder();

    [[nodiscard]] const QString& path() const { return m_path; } ///< the hidden name

    /// Writes the files to the disk and gives the folder its name; to be called once. What it
    /// replaces is kept until this is destroyed, and keeps its name if that fails; if the disk
    /// prevents even that, the error says where it is.
    /// Errors: FileExists (something was created there in the meantime), FileUnwritable.
    Result<void> commit();

private:
    StagedFolder() = default;

    [[nodiscard]] Result<void> exchange();

    QString m_target;
    QString m_path; ///< empty: nothing to remove
    bool m_replaceExisting = false;
};

} // namespace core
