// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"

#include <QObject>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

class QWidget;

namespace core {
struct ReadImport;
struct VolumeGeometry;
} // namespace core

namespace ui {

class Workspace;

/// The file filter of dialogs that ask for a mask file.
[[nodiscard]] QString maskFilter();

/// Imports segments from a mask file, or from those of a folder. They are read on another thread;
/// the segments become one step of the history. One import at a time. Where its segments overlap,
/// it waits until it is told what becomes of the voxels that they share.
class MaskImporter : public QObject {
    Q_OBJECT

public:
    MaskImporter(Workspace& workspace, QWidget* window);
    ~MaskImporter() override;

    /// Asks for a file and imports it.
    void ask();
    /// Asks for a folder of mask files and imports all of them.
    void askForFolder();
    /// @param path a file, or a folder of mask files (core::maskFilesIn())
    void import(const QString& path);
    /// The same for a path that was taken for a mask by its name only: if it holds an image,
    /// isImage() is emitted in place of failed().
    void importDropped(const QString& path);
    /// Continues an import that waits after overlapping(); otherwise does nothing.
    /// @param ahead ImportMask::ahead
    /// @param planes ImportMask::planes
    void import(const std::optional<std::vector<int>>& ahead,
        const std::optional<std::vector<int>>& planes);
    /// Gives up an import that waits after overlapping().
    void giveUp();
    [[nodiscard]] bool busy() const { return m_background.busy() || m_waiting; }

    /// Whether a dropped file or folder is a mask rather than a study, judged by its name or, for a
    /// DICOM file, by its SOP class. Reads no more than the beginning of the file.
    [[nodiscard]] static bool looksLikeMask(const QString& path);

Q_SIGNALS:
    void started(const QString& path);
    /// Segments of the file overlap. The import waits for import() or giveUp().
    void overlapping(const core::ReadImport& read, const core::VolumeGeometry& geometry);
    /// The import does not wait any longer, because the study was closed.
    void noLongerAsked();
    /// The import is in the history.
    /// @param notes what was resampled, left out or assumed, one sentence each
    void imported(const QString& rowName, const QStringList& notes);
    /// No voxel was free for the segments, so no step was made.
    void nothingTaken(const QString& path);
    void failed(const core::Error& error);
    void isImage(const QString& path); ///< after importDropped(); nothing was imported

private:
    struct Waiting;

    void read(const QString& path, bool mayBeImage);
    void take(const core::Result<core::ReadImport>& read, const QString& path);
    void apply(const core::ReadImport& read, const QString& path);
    /// Lets the 3D view show segments in the volume, unless it shows segments already.
    void showInVolume();

    Workspace& m_workspace;
    QWidget* m_window;
    std::unique_ptr<Waiting> m_waiting; ///< the import that waits after overlapping(); null: none
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
