// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class Workspace;

/// Measures the smallest distance between the surfaces of two segments (core/metrics/SegmentGap.h)
/// and keeps it as a measurement, which is a step that undo takes back, and tells what it is. The
/// engine reads the labels, another thread finds the places; the window goes on. What is asked for
/// is dropped when the session closes. Failures are reported by the workspace.
void measureDistance(Workspace& workspace, int label, int other);

} // namespace ui
