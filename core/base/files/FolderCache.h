// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QDateTime>
#include <QLockFile>
#include <QString>

#include <memory>
#include <vector>

namespace core {

/// A folder of folders that can be made again, of bounded size: what was used longest ago goes
/// first, and never what somebody has open, in whichever process. Nobody else may look into it, and
/// its names do not tell whose studies they are.
class FolderCache {
public:
    struct Entry {
        QString path;
        qint64 bytes = 0;
        QDateTime used;
    };
    /// Keeps an entry from being removed while it lives.
    using Hold = std::unique_ptr<QLockFile>;

    explicit FolderCache(QString folder);

    /// Makes the folder. FileUnwritable.
    [[nodiscard]] Result<void> prepare() const;
    /// Where an entry of this name has its place, whether it is there or not.
    [[nodiscard]] QString placeOf(const QString& name) const { return m_folder + u'/' + name; }
    /// Where it is to be gathered before it is renamed, with a lock beside it (".lock") that is
    /// held meanwhile. What is left there goes after a day.
    [[nodiscard]] static QString gatheringPlaceOf(const QString& path);
    /// Whether a path is one of its entries, or lies in one. @return that; empty: it does not
    [[nodiscard]] QString entryOf(const QString& path) const;

    /// Newest use first, whole ones only.
    [[nodiscard]] std::vector<Entry> entries() const;
    /// Of all that is there, also of what is still gathered.
    [[nodiscard]] qint64 bytes() const;
    /// Notes that it is used now.
    void touch(const QString& path) const;
    /// Null: it is gone.
    [[nodiscard]] Hold hold(const QString& path) const;
    [[nodiscard]] bool isHeld(const QString& path) const;

    /// Removes entries until no more than @p limit bytes are there. @return how many
    int shrinkTo(qint64 limit) const;
    /// Removes all that nobody holds.
    int clear() const { return shrinkTo(0); }

private:
    void remove(const QString& path) const;

    QString m_folder;
};

} // namespace core
