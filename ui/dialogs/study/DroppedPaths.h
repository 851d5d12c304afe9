// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

class QMimeData;

namespace ui {

class MaskImporter;
class MessageBar;
class StudyOpener;

/// The files and folders that are dropped on the window, in the order in which they come.
[[nodiscard]] QStringList droppedPaths(const QMimeData& data);

/// Opens what was dropped, or imports it if it is a mask and a study is open. Only one study, or
/// one mask, is taken; if there are more, the bar says so. Files of one folder, such as slices,
/// stand for the folder; of volumes, sessions, archives and folders, each of which is a study of
/// its own, the first one is opened. Reads the beginning of files.
/// @param paths droppedPaths(); at least one
void takeDropped(const QStringList& paths, bool isStudyOpen, StudyOpener& opener,
    MaskImporter& importer, MessageBar& bar);

} // namespace ui
