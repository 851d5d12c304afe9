// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"

#include <QObject>
#include <QStringList>

class QWidget;

namespace core {
struct ReadImport;
}

namespace ui {

class Workspace;

/// The file filter of dialogs that ask for a mask file.
[[nodiscard]] QString maskFilter();

/// Imports segments from a mask file. The file is read on another thread; its segments become one
/// step of the history. One file at a time.
class MaskImporter : public QObject {
    Q_OBJECT

public:
    MaskImporter(Workspace& workspace, QWidget* window);

    /// Asks for a file and imports it.
    void ask();
    void import(const QString& path);
    [[nodiscard]] bool busy() const { return m_background.busy(); }

    /// Whether a dropped file is a mask rather than a study, judged by its name or, for a DICOM
    /// file, by its SOP class. Reads no more than the beginning of the file.
    [[nodiscard]] static bool looksLikeMask(const QString& path);

Q_SIGNALS:
    void started(const QString& path);
    /// The import is in the history.
    /// @param notes what was resampled, left out or assumed, one sentence each
    void imported(const QString& rowName, const QStringList& notes);
    /// No voxel was free for the segments, so no step was made.
    void nothingTaken(const QString& path);
    void failed(const core::Error& error);

private:
    void apply(const core::Result<core::ReadImport>& read, const QString& path);

    Workspace& m_workspace;
    QWidget* m_window;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
