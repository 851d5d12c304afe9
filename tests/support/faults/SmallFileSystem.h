// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QTemporaryDir>

namespace test {

/// A file system of a few hundred kilobytes in memory that only this process and its children see
/// (in a mount namespace of their own). Make it before other threads need to see it.
class SmallFileSystem {
public:
    explicit SmallFileSystem(int kibibytes);
    SmallFileSystem(const SmallFileSystem&) = delete;
    SmallFileSystem& operator=(const SmallFileSystem&) = delete;
    ~SmallFileSystem();

    /// Why it could not be made (it needs the right to mount); empty if it was.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    [[nodiscard]] QString filePath(const QString& name) const { return m_folder.filePath(name); }
    void resize(int kibibytes);

private:
    QTemporaryDir m_folder; ///< where it is mounted
    QString m_problem;
};

} // namespace test
