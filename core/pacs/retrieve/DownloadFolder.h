// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QLockFile>
#include <QString>
#include <QStringList>

#include <memory>

namespace core {

/// A folder of downloaded objects that comes into being only when it is whole.
///
/// Until then they gather in a hidden folder beside it, which a later download into the same target
/// finds and goes on with. Nobody else uses it meanwhile. Files are brought to the disk all at once
/// when it ends; after a power failure before that, none of them is believed.
class DownloadFolder {
public:
    /// FileUnwritable, also where there is something at @p target, or another download goes there.
    [[nodiscard]] static Result<DownloadFolder> open(const QString& target);
    /// Whether @p target is a folder with all these objects, each of them sound.
    [[nodiscard]] static bool isWhole(const QString& target, const QStringList& sopInstanceUids);

    DownloadFolder(DownloadFolder&&) noexcept = default;
    DownloadFolder& operator=(DownloadFolder&&) noexcept = default;
    /// What has gathered stays; a folder without anything does not.
    ~DownloadFolder();

    /// Where the object gathers. Letters of a node get no say in it.
    [[nodiscard]] QString pathOf(const QString& sopInstanceUid) const;
    /// A name under which its file is written; a later download removes it.
    [[nodiscard]] QString partPathOf(const QString& sopInstanceUid) const;
    /// Whether it is here, from an earlier download, and sound; a damaged one is removed.
    [[nodiscard]] bool holds(const QString& sopInstanceUid) const;
    /// Gives a part that was checked its place. FileUnwritable.
    [[nodiscard]] Result<void> accept(const QString& partPath, const QString& sopInstanceUid) const;
    [[nodiscard]] const QString& target() const { return m_target; }

    /// Gives it its name. FileUnwritable.
    [[nodiscard]] Result<void> finish();

private:
    DownloadFolder() = default;

    QString m_target;
    QString m_gathering;
    std::unique_ptr<QLockFile> m_lock;
};

/// The SOP instance UID of a file that is a DICOM object that Burin can read to its end:
/// FileUnreadable, FileTruncated. Through the door that DicomFile is.
[[nodiscard]] Result<QString> soundObject(const QString& path);
/// Whether a file is such an object, of that UID.
[[nodiscard]] Result<void> checkObject(const QString& path, const QString& sopInstanceUid);

} // namespace core
