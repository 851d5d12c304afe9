// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/pacs/PacsRetrieve.h"

#include <QDateTime>
#include <QLockFile>
#include <QString>

#include <memory>
#include <vector>

namespace core {

/// A folder with what was downloaded, of bounded size: what was used longest ago goes first, and
/// never what somebody has open, in whichever process. Nobody else may look into it, and its names
/// do not tell whose studies they are.
class DownloadCache {
public:
    struct Entry {
        QString path;
        qint64 bytes = 0;
        QDateTime used;
    };
    /// Keeps an entry from being removed while it lives.
    using Hold = std::unique_ptr<QLockFile>;

    explicit DownloadCache(QString folder);

    /// Makes the folder. FileUnwritable.
    [[nodiscard]] Result<void> prepare() const;
    /// Where a wish at a source has its place, whether it is there or not.
    [[nodiscard]] QString pathOf(const QString& address, const RetrieveWish& wish) const;
    /// Whether a path is one of its entries, or lies in one. @return that; empty: it does not
    [[nodiscard]] QString entryOf(const QString& path) const;

    /// Newest use first, whole ones only.
    [[nodiscard]] std::vector<Entry> entries() const;
    /// Of all that is there, also of downloads that broke off.
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
