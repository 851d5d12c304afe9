// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace ui {

class Workspace;

/// Opens the dialogs that work on a segment as a whole when the workspace asks for them: reshaping,
/// filling between slices, splitting islands, a threshold. There is one of each; it stays open
/// beside @p window, and belongs to it.
void openSegmentDialogs(Workspace& workspace, QWidget& window);

} // namespace ui
