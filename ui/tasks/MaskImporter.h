// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/base/TaskThread.h"

#include <QObject>
#include <QStringList>

#include <memory>
#include <optional>

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
    ~MaskImporter() override; ///< cancels and waits

    /// Asks which file.
    void ask();
    void import(const QString& path);
    [[nodiscard]] bool busy() const { return m_progress != nullptr; }

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
    void take(const core::Result<core::ReadImport>& read, const QString& path);
    void apply(const core::Result<core::ReadImport>& read, const QString& path);

    Workspace& m_workspace;
    QWidget* m_window;
    const void* m_session = nullptr; ///< that it was begun for
    std::shared_ptr<core::Progress> m_progress; ///< none: nothing is under way
    std::optional<core::TaskThread> m_thread; ///< while a file is read
};

} // namespace ui
