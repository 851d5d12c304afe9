// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace ui {

class Workspace;

/// Asks before steps are lost that could not be written to disk. @return true if there are none, or
/// the user lets them go
[[nodiscard]] bool mayLoseUnwrittenSteps(Workspace& workspace, QWidget* parent);

} // namespace ui
