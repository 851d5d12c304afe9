// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace core {

/// Which file a path leads to, whatever links and spellings lie between: one that is there by
/// device and inode, a name that is still free by its folder and itself.
class FileIdentity {
public:
    /// None where there is not even a folder.
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
    QString m_name; ///< in the folder that the numbers name; empty: they name the file
};

/// While it lives these files are in use by this process: sources of a study, recipe, session.
/// StagedFile and SessionFile refuse to write over them, whoever asks. Any thread.
class FileInUse {
public:
    enum class As { Study, Session, Recipe, Mask };

    FileInUse() = default; ///< of nothing
    /// Paths that lead nowhere are left out. Cost: one look at the file system a path.
    FileInUse(const QStringList& paths, As what);
    FileInUse(FileInUse&& other) noexcept;
    FileInUse& operator=(FileInUse&& other) noexcept;
    ~FileInUse();

    /// What the file is in use as; none: it is not.
    [[nodiscard]] static std::optional<As> whatIs(const QString& path);
    /// The same as a clause, "it is the recipe".
    [[nodiscard]] static QString text(As what);

private:
    std::vector<FileIdentity> m_files;
    As m_what = As::Study;
};

} // namespace core
