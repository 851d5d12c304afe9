// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

class QPainter;

namespace ui {

class Workspace;

/// Draws a badge at every shown piece that is not at its true place: its name, how far it was moved
/// and turned, and its zoom, so that nobody takes the shown place for the true one.
void paintPieceBadges(QPainter& painter, const ViewContext& view, const Workspace& workspace);

} // namespace ui
