// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QDateTime>
#include <QLockFile>
#include <QString>

#include <memory>
#include <vector>

namespace core {

/// A cache of bounded size: a folder of folders that can be created again. The least recently used
/// one is removed first, and never one that some process has open. Other users cannot read it, and
/// its names do not reveal whose studies they are.
class FolderCache {
public:
    struct Entry {
        QString path;
        qint64 bytes = 0;
        QDateTime used;
    };
    /// Protects an entry from removal while it exists.
    using Hold = std::unique_ptr<QLockFile>;

    explicit FolderCache(QString folder);

    /// Creates the folder. Errors: FileUnwritable.
    [[nodiscard]] Result<void> prepare() const;
    /// The path of an entry with this name, whether or not it exists.
    [[nodiscard]] QString placeOf(const QString& name) const { return m_folder + u'/' + name; }
    /// Where an entry is collected before it is renamed, with a lock file beside it (".lock") that
    /// is held meanwhile. Leftovers are removed after a day.
    [[nodiscard]] static QString gatheringPlaceOf(const QString& path);
    /// The entry that a path is, or in which it lies; empty: none.
    [[nodiscard]] QString entryOf(const QString& path) const;

    /// The complete entries, last used first.
    [[nodiscard]] std::vector<Entry> entries() const;
    /// The size of everything there, including what is still being collected.
    [[nodiscard]] qint64 bytes() const;
    /// Marks an entry as used now.
    void touch(const QString& path) const;
    /// Null if the entry no longer exists.
    [[nodiscard]] Hold hold(const QString& path) const;
    [[nodiscard]] bool isHeld(const QString& path) const;

    /// Removes entries until at most @p limit bytes are left. @return how many were removed
    int shrinkTo(qint64 limit) const;
    /// Removes everything that is not held.
    int clear() const { return shrinkTo(0); }

private:
    void remove(const QString& path) const;

    QString m_folder;
};

} // namespace core
