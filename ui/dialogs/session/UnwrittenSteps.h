// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace ui {

class SessionSaver;
class Workspace;

/// Asks what is to be asked before the session is closed. If it is still being saved with images,
/// whether to wait for that or to cancel it. If there are steps that could not be written to disk,
/// asks whether they may be lost, and offers to save the session elsewhere with @p saver. Ends what
/// is under way (EditSession::endWork()), waits for the disk, and reports it if the session has
/// another name by now.
/// @return true if there are none left, or the user agrees to lose them
[[nodiscard]] bool mayLoseUnwrittenSteps(
    Workspace& workspace, QWidget& window, SessionSaver& saver);

} // namespace ui
