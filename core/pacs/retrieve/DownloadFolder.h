// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QLockFile>
#include <QString>
#include <QStringList>

#include <memory>

namespace core {

/// A folder of downloaded objects that appears only when it is complete.
///
/// Until then the objects are collected in a hidden folder beside it, which a later download into
/// the same target finds and continues. It is locked meanwhile. Files are written to the disk all
/// at once at the end; after a power failure before that, or if the disk refuses them, none of them
/// is trusted.
class DownloadFolder {
public:
    /// Errors: FileUnwritable, also if @p target exists or another download uses it.
    [[nodiscard]] static Result<DownloadFolder> open(const QString& target);
    /// Whether @p target is a folder with all these objects, each undamaged.
    [[nodiscard]] static bool isWhole(const QString& target, const QStringList& sopInstanceUids);
    /// Removes the lock of a download into @p target that was killed after all was in place. A lock
    /// that is held stays.
    static void removeLockLeftOver(const QString& target);

    DownloadFolder(DownloadFolder&&) noexcept = default;
    DownloadFolder& operator=(DownloadFolder&&) noexcept = default;
    /// Keeps what was collected, unless it is empty.
    ~DownloadFolder();

    /// The path at which the object is collected. It does not depend on characters chosen by the
    /// node.
    [[nodiscard]] QString pathOf(const QString& sopInstanceUid) const;
    /// The path under which its file is written; leftovers are removed by a later download.
    [[nodiscard]] QString partPathOf(const QString& sopInstanceUid) const;
    /// Whether an undamaged object is here from an earlier download; a damaged one is removed.
    [[nodiscard]] bool holds(const QString& sopInstanceUid) const;
    /// Moves a checked part to its path. Errors: FileUnwritable.
    [[nodiscard]] Result<void> accept(const QString& partPath, const QString& sopInstanceUid) const;
    [[nodiscard]] const QString& target() const { return m_target; }

    /// Gives the folder its name. Errors: FileUnwritable.
    [[nodiscard]] Result<void> finish();

private:
    DownloadFolder() = default;

    QString m_target;
    QString m_gathering;
    /// the disk refused the collected files, so none of them is trusted
    bool m_diskRefused = false;
    std::unique_ptr<QLockFile> m_lock;
};

/// The SOP instance UID of a file if it is a complete DICOM object that Burin can read; errors:
/// FileUnreadable, FileTruncated. The file is read through DicomFile.
[[nodiscard]] Result<QString> soundObject(const QString& path);
/// Checks that a file is such an object with that UID.
[[nodiscard]] Result<void> checkObject(const QString& path, const QString& sopInstanceUid);

} // namespace core
