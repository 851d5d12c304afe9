// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace core {

/// The file to which a path leads, independent of links and spelling: an existing file by device
/// and inode, a free name by its folder and the name itself.
class FileIdentity {
public:
    /// None if not even the folder exists.
    [[nodiscard]] static std::optional<FileIdentity> of(const QString& path);

    friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
    friend bool operator<(const FileIdentity& a, const FileIdentity& b)
    {
        return std::tie(a.m_device, a.m_inode, a.m_name)
            < std::tie(b.m_device, b.m_inode, b.m_name);
    }

private:
    std::uint64_t m_device = 0;
    std::uint64_t m_inode = 0;
    QString m_name; ///< in the folder given by the numbers; empty: they identify the file
};

/// While an object exists, its files are in use by this process: sources of a study, recipe,
/// session. StagedFile and SessionFile refuse to overwrite them. Any thread.
class FileInUse {
public:
    enum class As { Study, Session, Recipe, Mask, List };

    FileInUse() = default; ///< of no file
    /// Paths that lead nowhere are ignored. Cost: one file system call per path.
    FileInUse(const QStringList& paths, As what);
    FileInUse(FileInUse&& other) noexcept;
    FileInUse& operator=(FileInUse&& other) noexcept;
    ~FileInUse();

    /// What the file is used as; none: it is not used.
    [[nodiscard]] static std::optional<As> whatIs(const QString& path);
    /// The same as a clause, "it is the recipe".
    [[nodiscard]] static Clause text(As what);

private:
    std::vector<FileIdentity> m_files;
    As m_what = As::Study;
};

} // namespace core
