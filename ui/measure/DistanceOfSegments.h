// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class Workspace;

/// Measures the smallest distance between the surfaces of two segments (core/metrics/SegmentGap.h).
/// It becomes a distance measurement, which is a step that can be undone, and the workspace reports
/// its length. The call returns at once: the engine reads the labels and a background thread finds
/// the two places. Another call, or closing the session, drops the request. The workspace reports
/// that the measurement is running, and errors.
void measureDistance(Workspace& workspace, int label, int other);

} // namespace ui
