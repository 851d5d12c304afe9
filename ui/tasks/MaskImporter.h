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

/// Of dialogs that ask for a mask's file.
[[nodiscard]] QString maskFilter();

/// Brings segments in from a mask's file: it is read beside the window's work, what it holds
/// becomes one step. One file at a time.
class MaskImporter : public QObject {
    Q_OBJECT

public:
    MaskImporter(Workspace& workspace, QWidget* window);

    /// Asks which file.
    void ask();
    void import(const QString& path);
    [[nodiscard]] bool busy() const { return m_background.busy(); }

    /// Whether a file that was dropped is rather a mask than a study, by its name or, of a DICOM
    /// file, by what it says it is. Reads no more than its beginning.
    [[nodiscard]] static bool looksLikeMask(const QString& path);

Q_SIGNALS:
    void started(const QString& path);
    /// It stands in the history. @p notes: what was resampled, left out or taken for granted
    void imported(const QString& rowName, const QStringList& notes);
    /// No voxel was free for it; no step came of it.
    void nothingTaken(const QString& path);
    void failed(const core::Error& error);

private:
    void apply(const core::Result<core::ReadImport>& read, const QString& path);

    Workspace& m_workspace;
    QWidget* m_window;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
