// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace ui {

class SessionSaver;
class Workspace;

/// Asks before steps are lost that could not be written to disk; offers to save the session
/// elsewhere, by @p saver.
/// @return true if there are none (any more), or the user lets them go
[[nodiscard]] bool mayLoseUnwrittenSteps(
    Workspace& workspace, QWidget& window, SessionSaver& saver);

} // namespace ui
