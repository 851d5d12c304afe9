// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

namespace core {

/// The door for folders that are written, as StagedFile is for files: one that appears under its
/// name only once it is whole.
///
/// It is filled under a hidden name beside its target and renamed by commit(). Destroyed before
/// that it leaves nothing behind. It takes the place of nothing but an empty folder.
class StagedFolder {
public:
    /// Makes the empty folder. Errors: FileExists, FileUnwritable.
    static Result<StagedFolder> create(const QString& target);
    StagedFolder(StagedFolder&& other) noexcept;
    StagedFolder& operator=(StagedFolder&& other) noexcept;
    ~StagedFolder();

    [[nodiscard]] const QString& path() const { return m_path; } ///< the hidden name

    /// Brings the files to the disk and gives the folder its name; once.
    /// Errors: FileExists (something came into being there), FileUnwritable.
    Result<void> commit();

private:
    StagedFolder() = default;

    QString m_target;
    QString m_path; ///< empty: nothing to remove
};

} // namespace core
