// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

namespace core {

/// A file that appears under its name only once it is whole.
///
/// It is written under a temporary name in the folder of its target (same ending, so that readers
/// which go by the ending can check it), and renamed by commit(). Destroyed before commit() it
/// leaves nothing behind, and a file of the target's name is as it was.
class StagedFile {
public:
    /// Makes the empty temporary file.
    /// Errors: FileExists (unless @p replaceExisting), FileUnwritable.
    static Result<StagedFile> create(const QString& target, bool replaceExisting);

    StagedFile(StagedFile&& other) noexcept;
    StagedFile& operator=(StagedFile&& other) noexcept;
    ~StagedFile();

    [[nodiscard]] const QString& path() const { return m_path; } ///< the temporary name
    [[nodiscard]] const QString& target() const { return m_target; }

    /// Brings the content to the disk and gives the file its name; once.
    /// Errors: FileExists (it came into being meanwhile), FileUnwritable.
    Result<void> commit();

private:
    StagedFile() = default;

    QString m_path; ///< empty: nothing to remove
    QString m_target;
    bool m_replaceExisting = false;
};

} // namespace core
