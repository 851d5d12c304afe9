// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

class QMimeData;

namespace ui {

/// The files and folders that are dropped on the window, in the order in which they come.
[[nodiscard]] QStringList droppedPaths(const QMimeData& data);

/// What is opened of paths that are dropped at once: files of one folder, such as slices, stand for
/// the folder; of volumes, sessions, archives and folders, each of which is a study of its own, the
/// first one is. Reads the beginning of files.
/// @pre there is a path
[[nodiscard]] QString studyAmong(const QStringList& paths);

} // namespace ui
