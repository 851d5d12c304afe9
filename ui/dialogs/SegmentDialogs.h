// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace ui {

class Workspace;

/// From now on opens a dialog about a whole segment whenever the workspace asks for one: reshaping,
/// filling between slices, mirroring, splitting islands, threshold. There is one dialog of each
/// kind. It belongs to @p window and stays open beside it.
void openSegmentDialogs(Workspace& workspace, QWidget& window);

} // namespace ui
